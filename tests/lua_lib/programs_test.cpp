// Programs and subprograms, block delete, the limits of a run, and source locations of alarms.

#include <fmt/format.h>

#include "tests/lua_lib/run.h"

namespace gsim::script::programs_test {
namespace {

TEST(Programs, RunsFirstProgram) {
    expect_end(run("O1\nG0 X10\nM2\nO2\nG0 X20\nM99\n"), 10, 0, 0);
}

TEST(Programs, CallsAndRepeatsSubprogram) {
    const std::string sub = "O2\nG91 G0 X10\nG90\nM99\n";
    expect_end(run("O1\nM98 P2\nM2\n" + sub), 10, 0, 0);
    expect_end(run("O1\nM98 P2 L3\nM2\n" + sub), 30, 0, 0);
    expect_end(run("O1\nG0 Y5\nM98 P2 L0\nM2\n" + sub), 0, 5, 0);
    expect_end(run("O1\n#1=2\n#2=4\nM98 P#1 L#2\nM2\n" + sub), 40, 0, 0);
}

TEST(Programs, ModalStatePersistsAcrossCalls) {
    // The subprogram leaves G91 and G1 in force.
    expect_end(run("O1\nF1000 G0 X10\nM98 P2\nX5\nM2\nO2\nG91 G1 X1\nM99\n"), 16, 0, 0);
}

TEST(Programs, CallReturnsWithOrWithoutTargetBlock) {
    const std::string sub = "O5\nIF [#100 EQ 2] GOTO 8\nM99\nN8 M99 P30\n";
    for (const char* call : {"M98 P5", "G65 P5"}) {
        const std::string main = std::string(call) + "\nG01 X50 F500\nN30 G01 X60 F500\nM30\n";
        const Outcome plain = run("O1\n" + main + sub);
        expect_end(plain, 60, 0, 0);
        EXPECT_EQ(plain.moves.size(), 2U);
        const Outcome group_joints = run("O1\n#100=2\n" + main + sub);
        expect_end(group_joints, 60, 0, 0);
        EXPECT_EQ(group_joints.moves.size(), 1U) << "X50 is passed over";
    }
}

TEST(Programs, ReturnTargetAppliesToItsCallOnly) {
    // The first call continues at N20, the second one returns plainly.
    expect_end(run("O1\n#100=2\nM98 P5\nG0 Y1\nN20 #100=0\nM98 P5\nG0 X5\nM30\n"
                   "O5\nIF [#100 EQ 2] GOTO 8\nM99\nN8 M99 P20\n"),
               5, 0, 0);
}

TEST(Programs, ComputedJumpInLoopReachesLoopBlocks) {
    const auto with = [](int target) {
        return run(
            fmt::format("#9={}\nWHILE [#1 LT 2] DO1\n#1=#1+1\nGOTO #9\nG0 X[10*#1]\nN20 G0 Y[10*#1]\n"
                        "END1\nM30\nN30 G0 Z5\nM30\n",
                        target));
    };
    const Outcome inside = with(20);
    expect_end(inside, 0, 20, 0);
    EXPECT_EQ(inside.moves.size(), 2U);
    expect_end(with(30), 0, 0, 5);
    expect_alarm(with(40), 4, {"[jump]", "GOTO 40", "no block with that number"});
    // From an inner loop to a block of the outer one, and into a loop from outside.
    expect_end(
        run("#9=20\nWHILE [#1 LT 3] DO1\n#1=#1+1\nWHILE [1 EQ 1] DO2\nGOTO #9\nEND2\nN20 G91 G0 X1\nEND1\n"),
        3, 0, 0);
    expect_alarm(run("#9=20\nGOTO #9\nWHILE [#1 LT 1] DO1\n#1=#1+1\nN20 G0 X1\nEND1\n"), 2,
                 {"[jump]", "GOTO 20", "cannot enter a loop from outside"});
}

TEST(Programs, CallInLoopReturnsToLoopBlock) {
    expect_end(run("O1\nWHILE [#100 LT 2] DO1\n#100=#100+1\nM98 P5\nG0 X99\nN20 G91 G0 "
                   "Y1\nEND1\nM30\nO5\nM99 P20\n"),
               0, 2, 0);
}

TEST(Programs, NestToEightLevels) {
    std::string chain = "O1\nM98 P2\nM2\n";
    for (int n = 2; n <= 8; ++n) chain += fmt::format("O{}\nM98 P{}\nM99\n", n, n + 1);
    expect_end(run(chain + "O9\nG0 X1\nM99\n"), 1, 0, 0);
    expect_alarm(run(chain + "O9\nM98 P10\nM99\nO10\nG0 X1\nM99\n"), 26, {"O10", "8"});
    expect_alarm(run("O1\nM98 P2\nM2\nO2\nM98 P2\nM99\n"), 5, {"nested", "8"});
}

TEST(Programs, RejectsMissingProgram) {
    expect_alarm(run("O1\nG0 X1\n\nM98 P77\nM2\n"), 4, {"O77"});
    expect_alarm(run("O1\nG0 X1\nM98 P[1.5]\nM2\n"), 3, {"P", "1.5"});
    expect_alarm(run("O1\nG0 X1\nM98 P1 L[0-1]\nM2\n"), 3, {"L", "-1"});
    expect_alarm(run("O1\nG0 X1\nM98 P#5\nM2\n"), 3, {"P"});
    expect_alarm(run("O1\nG0 X1\nM98 P[EXP[700]]\nM2\n"), 3, {"[word-value]", "P of M98", "integer"});
    // 2^32 + 1 is not program 1.
    expect_alarm(run("O1\nG0 X1\nM98 P[4294967296+1]\nM2\n"), 3,
                 {"[word-value]", "P of M98", "integer", "4294967297"});
}

TEST(Programs, FindsExternalProgram) {
    Conditions setup;
    setup.options.find_program = [](const std::string& number) -> Result<std::optional<Script>> {
        if (number == "7")
            return Script::from_text("local _ENV = require \"gsim\" program(nil, function()\nG0{x=7.0}\nend)",
                                     "O0007.nc", -1);
        if (number == "8") return Unexpected("it is broken");
        return std::nullopt;
    };
    const Outcome r = run("O1\nM98 P7\nM98 P7\nM98 P8\nM2\n", setup);
    expect_alarm(r, 4, {"it is broken"});
    ASSERT_EQ(r.moves.size(), 1U);
    EXPECT_EQ(r.report.source.files[r.moves[0].info.location.file], "O0007.nc");
    EXPECT_EQ(r.moves[0].info.location.line, 1U);
    expect_alarm(run("O1\nM98 P9\nM2\n", setup), 2, {"O9"});
}

TEST(Programs, EndInSubprogramEndsRun) {
    expect_end(run("O1\nM98 P2\nG0 X99\nM2\nO2\nG0 X5\nM2\nG0 X6\nM99\n"), 5, 0, 0);
    expect_end(run("O1\nM98 P2\nG0 X99\nM2\nO2\nG0 X5\nM30\n"), 5, 0, 0);
}

TEST(Programs, AcceptsMainProgramWithoutEnd) {
    expect_end(run("G0 X5"), 5, 0, 0);
    EXPECT_TRUE(run("").completed());
    EXPECT_TRUE(run("%\n%\n").completed());
}

TEST(Programs, M99InMainProgramEndsPass) {
    const Outcome one = run("G0 X100\nX0\nM99\n");
    expect_end(one, 0, 0, 0);
    EXPECT_EQ(one.moves.size(), 2U);
    ASSERT_TRUE(one.report.passes);
    EXPECT_EQ(one.report.passes->count, 1U);
    EXPECT_EQ(one.report.passes->location.line, 3U);
    EXPECT_EQ(one.report.passes->to_block, std::nullopt);
    Conditions setup;
    setup.options.passes = 3;
    const Outcome three = run("G0 X100\nX0\nM99\n", setup);
    expect_end(three, 0, 0, 0);
    EXPECT_EQ(three.moves.size(), 6U);
    EXPECT_NEAR(three.report.cycle_time_s, 3 * one.report.cycle_time_s, 1e-9);
    EXPECT_EQ(three.report.passes->count, 3U);
    EXPECT_TRUE(run("M99\n").completed()) << "nothing moves in between";
    EXPECT_EQ(run("G0 X1\nM30\n").report.passes, std::nullopt);
    EXPECT_EQ(run("O1\nM98 P2\nM30\nO2\nG0 X1\nM99\n").report.passes, std::nullopt) << "a return is none";
}

TEST(Programs, M30EndsPasses) {
    Conditions setup;
    setup.options.passes = 9;
    const Outcome r = run("#1=#1+1\nG91 G0 X1\nIF [#1 EQ 3] GOTO 5\nM99\nN5 M30\n", setup);
    expect_end(r, 3, 0, 0);
    EXPECT_EQ(r.report.passes->count, 2U) << "the third one comes to M30";
}

TEST(Programs, JumpBackAtEndOfMainProgramEndsPass) {
    for (const char* last : {"M99 P10", "GOTO 10", "/M99 P10"}) {
        const std::string gcode = "G0 X5\nN10 G91 G0 Y1\n" + std::string(last) + "\n%\n";
        const Outcome one = run(gcode);
        expect_end(one, 5, 1, 0);
        ASSERT_TRUE(one.report.passes) << last;
        EXPECT_EQ(one.report.passes->to_block, 10);
        EXPECT_EQ(one.report.passes->location.line, 3U);
        Conditions setup;
        setup.options.passes = 4;
        expect_end(run(gcode, setup), 5, 4, 0);
    }
    // A jump that is not in the last block, or is conditional, makes a normal loop.
    const Outcome loop = run("N10 G91 G0 Y1\n#1=#1+1\nIF [#1 LT 3] GOTO 10\n");
    expect_end(loop, 0, 3, 0);
    EXPECT_EQ(loop.report.passes, std::nullopt);
    expect_end(run("N10 G91 G0 Y1\n#1=#1+1\nIF [#1 EQ 3] GOTO 20\nM99 P10\nN20 M30\n"), 0, 3, 0);
}

TEST(Programs, PassesStopAtRunLimits) {
    Conditions setup;
    setup.options.passes = 1000;
    setup.limits.max_time_s = 10;
    const Outcome r = run("G0 X100\nX0\nM99\n", setup);
    expect_stopped(r, "--max-time");
    EXPECT_GT(r.report.cycle_time_s, 10);
    EXPECT_LT(r.report.cycle_time_s, 11);
    setup.limits = {};
    setup.limits.max_blocks = 100;
    const Outcome blocks = run("G0 X100\nX0\nM99\n", setup);
    expect_stopped(blocks, "--max-blocks");
    EXPECT_EQ(blocks.report.counts.blocks, 100U);
}

TEST(Programs, LoopWithoutMotionStopsAtStepLimit) {
    Conditions setup;
    setup.options.limits.steps = 1'000'000;
    // In parts the loop runs the same, but may end at another step.
    const Outcome r = run_lua("G0{x=1}\nwhile 1.0 == 1.0 do\nv[1] = v[1] + 1.0\nend\n", setup);
    expect_stopped(r, "--max-steps");
    EXPECT_GE(r.line(), 2U);
    EXPECT_LE(r.line(), 4U);
    expect_stopped(run("N1 GOTO1\nM30\n", setup), "--max-steps");
}

TEST(Programs, BlockDeleteSkipsBlocks) {
    Conditions setup;
    EXPECT_EQ(run("G0 X1\n/X2\n/2 X3\n").end()[0], 3);
    setup.options.block_delete = true;
    expect_end(run("G0 X1\n/X2\n/2 X3\n", setup), 1, 0, 0);
    expect_end(run("G0 X1\n/GOTO9\nX2\nN9\n", setup), 2, 0, 0);
    expect_end(run("GOTO9\nX5\n/N9 G0 X2\nG0 Y3\n", setup), 0, 3, 0);
}

TEST(Programs, ReportsOptionalStopIfOnOrOff) {
    Conditions setup;
    EXPECT_EQ(run("M1\n").report.events.at(0).detail, "off: skipped");
    setup.options.optional_stop = true;
    EXPECT_EQ(run("M1\n", setup).report.events.at(0).detail, "");
}

TEST(Programs, BlocksAreCountedOnce) {
    EXPECT_EQ(run("G17 G21 G90 G0 X1 F100\n\n(nothing)\nX2\n#1=2\nM2\n").report.counts.blocks, 3U);
    EXPECT_EQ(run("O1\nM98 P2 L5\nM2\nO2\nG91 G0 X1\nM99\n").report.counts.blocks, 12U);
}

TEST(SourceLocations, ExpressionAlarmHasItsLine) {
    expect_alarm(run("G0 X1\n\n#1=1/0\n"), 3, {"division by zero"});
    expect_alarm(run("G0 X1\n#1=SQRT[-4]\n"), 2, {"SQRT", "-4"});
    expect_alarm(run("G0 X1\nG0 X[1/0]\n"), 2, {"division by zero"});
    expect_alarm(run("O1\nG0 X1\nM98 P2\nM2\nO2\nG0 X2\n#50=1\nM99\n"), 7, {"#50"});
    expect_alarm(run("G0 X1\nIF[1 EQ 1]GOTO[#1+2.5]\nN2\n"), 2, {"2.5"});
    expect_alarm(run("O1\nG0 X1\nM98 P2\nM2\nO2\nG0 X2\nM99 P[1.5]\n"), 7, {"1.5"});
    expect_alarm(run("G0 X1\n\nGOTO[#1+3]\nN2\n"), 3, {"3"});
}

TEST(SourceLocations, MovesHaveLineOfGCode) {
    const Outcome r = run("(head)\nO1\nG0 X1\n\nX2 (two)\nM98 P2\nM2\nO2\nX3\nM99\n");
    ASSERT_EQ(r.moves.size(), 3U);
    EXPECT_EQ(r.moves[0].info.location.line, 3U);
    EXPECT_EQ(r.moves[1].info.location.line, 5U);
    EXPECT_EQ(r.moves[2].info.location.line, 9U);
}

}  // namespace
}  // namespace gsim::script::programs_test
