// RS274/NGC: parameters, subroutines, frames, home points, modal state, inputs and outputs. The expected
// values are those that LinuxCNC's interpreter gives for the same programs, or worked out by hand.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::ngc_test {
namespace {

// Returns the value of an expression, printed with six decimals.
std::string variable_value(const std::string& expression) {
    return debug_texts(run_ngc("#100=" + expression + "\n(debug,#100)\nM2\n"));
}

TEST(NgcExpressions, LogicTreatsNonzeroAsTrue) {
    EXPECT_EQ(variable_value("[2 and 3]"), "1.000000\n");
    EXPECT_EQ(variable_value("[0 or 5]"), "1.000000\n");
    EXPECT_EQ(variable_value("[2 xor 3]"), "0.000000\n");
    EXPECT_EQ(variable_value("[1 and 0.00000001]"), "1.000000\n");
}

TEST(NgcExpressions, OnlyEqualityHasTolerance) {
    EXPECT_EQ(variable_value("[1 eq 1.00009]"), "1.000000\n");
    EXPECT_EQ(variable_value("[1 eq 1.00011]"), "0.000000\n");
    EXPECT_EQ(variable_value("[1 ne 1.00009]"), "0.000000\n");
    EXPECT_EQ(variable_value("[1 lt 1.00000001]"), "1.000000\n");
    EXPECT_EQ(variable_value("[1 ge 1.0000001]"), "0.000000\n");
}

TEST(NgcExpressions, ComputeRemainderRoundingAndAngles) {
    EXPECT_EQ(variable_value("[-7 mod 3]"), "2.000000\n");
    EXPECT_EQ(variable_value("[7 mod -3]"), "1.000000\n");
    EXPECT_EQ(variable_value("[-5.5 mod 2]"), "0.500000\n");
    EXPECT_EQ(variable_value("[1 mod 0.1]"), "0.100000\n") << "0.1 is a little more than a tenth";
    EXPECT_EQ(variable_value("[2 ** 80 mod 10]"), "6.000000\n");
    EXPECT_EQ(variable_value("round[-2.5]"), "-3.000000\n");
    EXPECT_EQ(variable_value("fix[-2.5]"), "-3.000000\n");
    EXPECT_EQ(variable_value("fup[-2.5]"), "-2.000000\n");
    EXPECT_EQ(variable_value("atan[-1]/[-1]"), "-135.000000\n");
    EXPECT_EQ(variable_value("atan[0]/[-1]"), "180.000000\n");
    EXPECT_EQ(variable_value("[2 ** -1]"), "0.500000\n");
}

TEST(NgcExpressions, RejectsExpressionWithoutValue) {
    for (const char* expression : {"[1/0]", "[5 mod 0]", "[[0-2]**0.5]", "[0**[0-1]]", "exp[1000]",
                                   "sqrt[-1]", "ln[0]", "acos[2]", "#0", "#5602", "#[1.5]", "#<nothing>"}) {
        const Outcome r = run_ngc(std::string("#100=") + expression + "\nM2\n");
        EXPECT_EQ(r.report.status, simulation::RunStatus::alarm) << expression;
        EXPECT_EQ(r.line(), 1U) << expression;
    }
}

TEST(NgcParameters, UnsetNumberedAreZeroAndNamedAreRejected) {
    EXPECT_EQ(variable_value("[#77+1]"), "1.000000\n");
    expect_alarm(run_ngc("G21\n#1=#<width>\nM2\n"), 2, {"#<width>", "no value"});
    EXPECT_EQ(debug_texts(run_ngc("(debug,#<width> #5)\nM2\n")), "###### 0.000000\n");
    EXPECT_EQ(debug_texts(run_ngc(
                  "#<a>=1\n#1=exists[#<a>] #2=exists[#<b>] #3=exists[#<_x>]\n(debug,#1 #2 #3)\nM2\n")),
              "1.000000 0.000000 1.000000\n");
}

TEST(NgcParameters, ControllerParametersAreReadOnly) {
    for (const char* parameter : {"#5420", "#5400", "#5401", "#5413", "#<_x>", "#<_value>"})
        expect_alarm(run_ngc(std::string("G21\n") + parameter + "=1\nM2\n"), 2, {parameter, "read-only"});
    EXPECT_EQ(debug_texts(run_ngc("#5399=5\n(debug,#5399)\nM2\n")), "5.000000\n");
}

TEST(NgcParameters, ReportControllerState) {
    EXPECT_EQ(debug_texts(run_ngc(
                  "G20 G18 G91 F3\nG1 X1 Z2\n\n"
                  "(debug,#<_x> #<_z> #5420 #<_plane> #<_metric> #<_incremental> #<_feed> #<_line>)\nM2\n")),
              "1.000000 2.000000 1.000000 180.000000 0.000000 1.000000 3.000000 4.000000\n");
    EXPECT_EQ(
        debug_texts(run_ngc(
            "G59.2 G95 G98 S70 M4\n"
            "(debug,#<_coord_system> #<_units_per_rev> #<_retract_old_z> #<_rpm> #<_spindle_cw>)\nM2\n")),
        "592.000000 1.000000 1.000000 70.000000 0.000000\n");
}

TEST(NgcSubroutines, HaveLocalParametersAndReturnValue) {
    const Outcome r = run_ngc(
        "#1=5 #<a>=1\n"
        "o1 sub\n(debug,#1 #2 #30 #<_call_level>)\n#1=7 #<a>=3\no1 endsub [#1+1]\n"
        "o2 sub\no2 endsub\n"
        "o1 call [2] [3]\n(debug,#1 #<a> #<_value> #<_value_returned>)\n"
        "o2 call\n(debug,#<_value> #<_value_returned>)\nM2\n");
    EXPECT_EQ(
        debug_texts(r),
        "2.000000 3.000000 0.000000 1.000000\n5.000000 1.000000 8.000000 1.000000\n0.000000 0.000000\n");
}

TEST(NgcSubroutines, GlobalNamesAreVisibleEverywhere) {
    EXPECT_EQ(
        debug_texts(run_ngc("o1 sub\n#<_g>=[#<_g>+1]\no1 endsub\n#<_g>=1\no1 call\n(debug,#<_g>)\nM2\n")),
        "2.000000\n");
    expect_alarm(run_ngc("o1 sub\n#5=#<local>\no1 endsub\n#<local>=1\no1 call\nM2\n"), 2, {"#<local>"});
}

TEST(NgcSubroutines, NestToNineLevels) {
    const std::string program = "o1 sub\no2 if [#1 gt 1]\no1 call [#1-1]\no2 endif\no1 endsub\no1 call [";
    EXPECT_TRUE(run_ngc(program + "9]\nM2\n").completed());
    expect_alarm(run_ngc(program + "10]\nM2\n"), 3, {"o1", "9 deep"});
}

TEST(NgcSubroutines, MayBeDefinedAfterCallAndProgramEnd) {
    EXPECT_EQ(
        debug_texts(run_ngc("#1=1\no1 call [2]\no1 sub\n(debug,sub #1)\no2 call\no1 endsub\n(debug,main #1)\n"
                            "o1 call [3]\nM2\no2 sub\n(debug,two)\no2 endsub\nnot read @\n")),
        "sub 2.000000\ntwo\nmain 1.000000\nsub 3.000000\ntwo\n");
    expect_alarm(run_ngc("o1 call\nM2\no1 sub\n\n#5=[1/0]\no1 endsub\n"), 5, {"zero"});
}

TEST(NgcSubroutines, ReportsNameOfMissingSubroutine) {
    expect_alarm(run_ngc("G21\no<drill> call [1]\nM2\n"), 2, {"o<drill>", "subroutine not found"});
}

TEST(NgcSubroutines, RepeatCountIsRoundedHalfToEven) {
    const std::string count = "o1 repeat [%]\n#9=[#9+1]\no1 endrepeat\n";
    const auto passes = [&](const std::string& n) {
        std::string program = count;
        return debug_texts(run_ngc(program.replace(program.find('%'), 1, n) + "(debug,%d#9)\nM2\n"));
    };
    EXPECT_EQ(passes("2.5"), "2\n");
    EXPECT_EQ(passes("3.5"), "4\n");
    EXPECT_EQ(passes("0.6"), "1\n");
    EXPECT_EQ(passes("-1"), "0\n");
}

TEST(NgcMessages, AreFormattedAsProgrammed) {
    EXPECT_EQ(debug_texts(run_ngc("#1=1.6 #2=-3.25\n(debug,#1 %d#1 %.2f#2 %.4f#1)\nM2\n")),
              "1.600000 2 -3.25 1.6000\n");
    const Outcome r =
        run_ngc("(msg, as it is #1)\n(print,#1)\n(log,a)\n(logopen,x.txt)\n#5599=0\n(debug,not shown)\nM2\n");
    EXPECT_EQ(r.events(), "message print log log_open");
    EXPECT_EQ(r.report.events.at(0).detail, " as it is #1");
}

TEST(NgcExpressions, SettingsInMoveBlockReadStateBeforeBlock) {
    const Outcome r = run_ngc("G21 F100\nG1 X5\nX9 #1=[#5420+1] #1=[#5420+2]\nX#1\nM2\n");
    EXPECT_NEAR(r.to(2, 'X'), 7, 1e-9);
}

// --- Frames ---

TEST(NgcFrames, SystemRotatesAboutItsOrigin) {
    const Outcome r = run_ngc("G21 G10 L2 P1 X10 Y20 R30\nG0 X2 Y0\nX0 Y2\nG91 X1\nM2\n");
    const double c = std::sqrt(0.75);
    EXPECT_NEAR(r.to(0, 'X'), 10 + 2 * c, 1e-9);
    EXPECT_NEAR(r.to(0, 'Y'), 20 + 1, 1e-9);
    EXPECT_NEAR(r.to(1, 'X'), 10 - 1, 1e-9);
    EXPECT_NEAR(r.to(1, 'Y'), 20 + 2 * c, 1e-9);
    EXPECT_NEAR(r.to(2, 'X'), 10 - 1 + c, 1e-9);
    EXPECT_NEAR(r.to(2, 'Y'), 20 + 2 * c + 0.5, 1e-9);
}

TEST(NgcFrames, G92RotatesWithSystemAndG923RestoresIt) {
    EXPECT_EQ(
        debug_texts(run_ngc(
            "G21 G10 L2 P1 X1 Y2 R30\nG0 X10 Y4\nG92 X5 Y1\n(debug,%.4f#<_x> #<_y> #<_abs_x> #<_abs_y>)\n"
            "G92.2\n(debug,%.4f#<_x> #<_y>)\nG92.3\n(debug,%.4f#<_x> #<_y>)\n"
            "G52 X1 Y1\n(debug,%.4f#<_x> #<_y>)\nG92.1\n(debug,%.4f#<_x> #5210)\nM2\n")),
        "5.0000 1.0000 7.6603 10.4641\n10.0000 4.0000\n5.0000 1.0000\n9.0000 3.0000\n10.0000 0.0000\n");
}

TEST(NgcFrames, G10L20SetsOriginFromPosition) {
    EXPECT_EQ(
        debug_texts(run_ngc("G21 G10 L2 P1 X10 Y20 R60\nG0 X1 Y2\nG10 L20 P0 X5 Y6\n"
                            "(debug,%.4f#<_x> #<_y> #5230)\nG10 L20 P2 Z7\nG55\n(debug,%.4f#<_z>)\nM2\n")),
        "5.0000 6.0000 60.0000\n7.0000\n");
}

TEST(NgcFrames, ParametersAreInInchesAndApplyAtSystemChange) {
    EXPECT_EQ(debug_texts(run_ngc(
                  "G21 G10 L2 P1 X25.4\n(debug,#5221 #<_x>)\n#5221=2\n(debug,#<_x>)\nG54\n(debug,#<_x>)\n"
                  "G55\nG54\n(debug,#<_x>)\nM2\n")),
              "1.000000 -25.400000\n-25.400000\n-25.400000\n-50.800000\n");
}

TEST(NgcFrames, RejectsInvalidWordsOfG10) {
    expect_alarm(run_ngc("G21\nG10 L2 P10 X1\nM2\n"), 2, {"P", "0", "9"});
    expect_alarm(run_ngc("G21\nG10 L20 P1 X1 R3\nM2\n"), 2, {"R"});
    expect_alarm(run_ngc("G21\nG10 L1 P77 Z1\nM2\n"), 2, {"tool 77"});
    expect_alarm(run_ngc("G21\nG10 L3 P1 X1\nM2\n"), 2, {"L"});
}

TEST(NgcFrames, ToolOffsetsAreNotRotated) {
    const Outcome r = run_ngc("G21 G10 L2 P1 R90\nT1 M6\nG10 L1 P1 X3 Z5\nG43\nG0 X1 Y0 Z1\nM2\n");
    EXPECT_NEAR(r.to(0, 'X'), 3, 1e-9);
    EXPECT_NEAR(r.to(0, 'Y'), 1, 1e-9);
    EXPECT_NEAR(r.to(0, 'Z'), 6, 1e-9);
}

TEST(NgcFrames, G10L10AndL11SetToolTableByPosition) {
    // With tool 2 active the machine is at X2 Y3 Z1 (values of LinuxCNC).
    EXPECT_EQ(debug_texts(run_ngc("G21 T1 M6\nG10 L2 P1 X1 Z3 R30\nG0 X5 Y5 Z5\nG92 X3\nG10 L10 P2 X2 Y3 Z1\n"
                                  "G43 H2\n(debug,%.4f#<_x> #<_y> #<_z>)\nM2\n")),
              "2.0000 3.0000 1.0000\n");
    EXPECT_EQ(
        debug_texts(run_ngc("G21 T1 M6\nG10 L1 P1 Z0\nG10 L2 P1 X1 Z3 R30\nG0 X5 Y5 Z5\nG92 X3\n"
                            "G10 L2 P9 X4 Z2 R10\nG10 L11 P1 X2 Y3 Z1\n(debug,%.4f#5401 #5402 #5403)\nM2\n")),
        "-0.1031 0.1389 0.1969\n");
}

TEST(NgcFrames, G53RequiresAbsoluteMode) {
    expect_alarm(run_ngc("G91\nG53 G0 X1\nM2\n"), 2, {"G53", "G90"});
    const Outcome r = run_ngc("G21 G10 L2 P1 X10 R45\nG53 G0 X3 Y4\nM2\n");
    EXPECT_NEAR(r.to(0, 'X'), 3, 1e-9);
    EXPECT_NEAR(r.to(0, 'Y'), 4, 1e-9);
}

TEST(NgcHome, PassesIntermediatePointInProgramDirections) {
    const Outcome r =
        run_ngc("G21 G10 L2 P1 X10 Y20 R90\nG0 X1 Y2 Z3\nG28.1\nG0 X5 Y5 Z6\nG28 X6 Z7\nG28\nM2\n");
    // Only X and Z of the program go home; its X is the machine's Y.
    EXPECT_NEAR(r.to(2, 'Y'), 26, 1e-9);
    EXPECT_NEAR(r.to(3, 'X'), 5, 1e-9);
    EXPECT_NEAR(r.to(3, 'Y'), 21, 1e-9);
    EXPECT_NEAR(r.to(3, 'Z'), 3, 1e-9);
    EXPECT_NEAR(r.end()[0], 8, 1e-9);
    EXPECT_NEAR(r.end()[1], 21, 1e-9);
}

TEST(NgcHome, HomeAndG92ComeFromPreviousRun) {
    Conditions setup = ngc_conditions();
    setup.options.data.variables = {{5161, 1}, {5210, 1}, {5211, 0.5}};
    const Outcome r = run_ngc("G21 G90\nG0 X0\nG28\nM2\n", setup);
    ASSERT_EQ(r.moves.size(), 2U) << r.message();
    EXPECT_NEAR(r.to(0, 'X'), 12.7, 1e-9);
    EXPECT_NEAR(r.to(1, 'X'), 25.4, 1e-9);
    setup.options.data.variables[5210] = 0;
    EXPECT_NEAR(run_ngc("G21 G90\nG0 X1\nM2\n", setup).to(0, 'X'), 1, 1e-9) << "G92.2 has ended it";
}

TEST(NgcFrames, RejectsFrameAndModeChangesDuringCompensation) {
    for (const char* word : {"G92 X1", "G52 X1", "G55", "G10 L2 P1 X1", "G28", "G28.1", "G53 G0 X1", "G18",
                             "M66 P1 L0", "M62 P1", "G64", "G61", "G38.2 X9", "G5.1 X1 Y1 I1 J1", "M48"}) {
        const Outcome r = run_ngc("G21 F100 T1 M6\nG41 D1\nG1 X10 Y10\n" + std::string(word) + "\nM2\n");
        expect_alarm(r, 4, {"compensation"});
    }
}

// --- Modes ---

TEST(NgcModes, AreSavedAndRestored) {
    EXPECT_EQ(
        debug_texts(run_ngc(
            "G21 F100 S200 M3\nM70\nG20 G91 F5 S7 G55 G18 M5 M8 G90.1 G98\nM72\n"
            "(debug,%d#<_metric> #<_absolute> #<_feed> #<_rpm> #<_coord_system> #<_plane> #<_spindle_on> "
            "#<_flood> #<_ijk_absolute_mode> #<_retract_old_z>)\nM2\n")),
        "1 1 100 200 540 170 1 0 0 0\n");
}

TEST(NgcModes, OverridesAreRestoredInFixedOrder) {
    const Outcome r = run_ngc("M49\nM52\nM53 P0\nM70\nM48\nM52 P0\nM53\nM72\nM2\n");
    ASSERT_EQ(r.report.events.size(), 12U) << r.message();
    const char* const expected_value[] = {"feed disabled", "speed disabled", "adaptive enabled",
                                          "hold disabled"};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(r.report.events[8 + i].detail, expected_value[i]);
}

TEST(NgcModes, M73RestoresModesAfterSubroutine) {
    const std::string body = "G20 G91\no1 endsub\nG21 G90\no1 call\n(debug,%d#<_metric> #<_absolute>)\nM2\n";
    EXPECT_EQ(debug_texts(run_ngc("o1 sub\nM73\n" + body)), "1 1\n");
    EXPECT_EQ(debug_texts(run_ngc("o1 sub\nM73\nM71\n" + body)).substr(0, 3), "0 0");
    expect_alarm(run_ngc("G21\nM72\nM2\n"), 2, {"M72", "M70"});
}

TEST(NgcModes, SurfaceSpeedAtX0WithoutLimitOnlyWarns) {
    const Outcome r = run_ngc("G21\nG96 S100 M3\nG0 X10\nM2\n");
    EXPECT_TRUE(r.completed()) << r.message();
    EXPECT_EQ(r.moves.size(), 1U);
    const auto& warnings = r.report.messages.warnings;
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
        return warning.find("G96 at X0: the speed has no maximum and is set to 0") != std::string::npos;
    }));
}

TEST(NgcModes, AxisWordsRequireMotion) {
    expect_alarm(run_ngc("G21\nX5\nM2\n"), 2, {"motion"});
}

// --- Inputs and outputs ---

TEST(NgcInputs, ReadZeroWithoutScriptAndElseItsValue) {
    EXPECT_EQ(debug_texts(run_ngc("#5399=3\nM66 P1 L3 Q2\n(debug,#5399)\nM2\n")), "0.000000\n");
    const Outcome r = run_ngc_lua(
        "on_input(function(kind, number, wait, timeout) if wait == 3 then return nil end return number + "
        "0.5, 1 end)\n"
        "M66{e=2, l=0} DEBUG('%f', v[5399])\n"
        "M66{p=1, l=1, q=5} DEBUG('%f', v[5399])\n"
        "M66{p=1, l=3, q=5} DEBUG('%f', v[5399])\n");
    EXPECT_EQ(debug_texts(r), "2.500000\n1.500000\n-1.000000\n");
    EXPECT_NEAR(r.report.cycle_time_s, 1 + 5, 1e-9);  // one response after 1 s, none within 5 s
}

TEST(NgcInputs, RejectsInvalidWords) {
    expect_alarm(run_ngc("G21\nM66 P1 E1 L0\nM2\n"), 2, {"digital", "analog"});
    expect_alarm(run_ngc("G21\nM66 P1 L3\nM2\n"), 2, {"Q"});
    expect_alarm(run_ngc("G21\nM66 E1 L1 Q1\nM2\n"), 2, {"analog"});
    expect_alarm(run_ngc_lua("M68{e=1}"), 1, {"Q"});
}

TEST(NgcOutputs, AreReportedAsEvents) {
    const Outcome r = run_ngc("M62 P1\nM65 P2\nM67 E3 Q1.5\nG0 X1\nM2\n");
    ASSERT_EQ(r.events(), "digital_output digital_output analog_output");
    EXPECT_EQ(r.report.events.at(0).detail, "P1 on with the next move");
    EXPECT_EQ(r.report.events.at(1).detail, "P2 off");
    EXPECT_EQ(r.report.events.at(2).detail, "E3 1.5 with the next move");
}

// M62, M63 and M67 wait for a move, which a dwell is not; the others stop the machine and act at once.
TEST(NgcOutputs, ChangeWithNextMoveOrAtOnce) {
    const Outcome r = run_ngc(
        "G21 G64\nM62 P1\nG4 P1\nG1 X10 F600\nM64 P2\nG1 X20\nM67 E1 Q2\nM63 P3\nM68 E2 Q5\nG1 X30\nM62 "
        "P4\nG4 P1\nM65 P5\nM2\n");
    ASSERT_EQ(r.moves.size(), 5U);
    const auto run_time_s = [&](const std::string& detail) {
        for (const simulation::Event& event : r.report.events)
            if (event.detail == detail) return event.t_s;
        return -1.0;
    };
    EXPECT_EQ(r.moves[1].start_s, 1);
    EXPECT_EQ(run_time_s("P1 on with the next move"), r.moves[1].start_s);
    EXPECT_EQ(run_time_s("P2 on"), r.moves[1].end_s);
    EXPECT_EQ(run_time_s("E1 2 with the next move"), r.moves[3].start_s);
    EXPECT_EQ(run_time_s("P3 off with the next move"), r.moves[3].start_s);
    EXPECT_EQ(run_time_s("E2 5"), r.moves[2].end_s);
    EXPECT_EQ(run_time_s("P4 on with the next move"), -1);  // no move comes any more
    EXPECT_EQ(run_time_s("P5 off"), r.moves[4].end_s);
}

// If the controller does not stop, the next move begins in the corner.
TEST(NgcOutputs, SynchronizedOutputsDoNotStopMotion) {
    Conditions conditions = ngc_conditions();
    conditions.machine.controller.planner = rrs::PlannerKind::look_ahead;
    for (machine::Axis& axis : conditions.machine.axes) axis.max_acceleration = 100;
    const std::string before = "G21 G64\nG1 X10 F600\n";
    const Outcome through = run_ngc(before + "M62 P1\nX20\nM2\n", conditions);
    const Outcome without = run_ngc(before + "X20\nM2\n", conditions);
    const Outcome stopped = run_ngc(before + "M64 P1\nX20\nM2\n", conditions);
    EXPECT_EQ(through.report.cycle_time_s, without.report.cycle_time_s);
    EXPECT_EQ(through.report.events.at(0).t_s, through.moves.at(1).start_s);
    EXPECT_LT(through.report.cycle_time_s, stopped.report.cycle_time_s);
}

}  // namespace
}  // namespace gsim::script::ngc_test
