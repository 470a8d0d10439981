// Effect of a program's angles on rotary axes, and further home positions of the machine file.

#include <gtest/gtest.h>

#include "tests/lua_lib/run.h"

namespace gsim::script::turning_test {
namespace {

// The built-in machine with B endless, or of a range, and turning so.
Conditions with_turning(machine::RotaryMode turning, double range_deg = 1e9) {
    Conditions conditions;
    machine::Axis& b = conditions.machine.axes[3];
    b.turning = turning;
    b.min = -range_deg;
    b.max = range_deg;
    return conditions;
}

// Returns B at the end of each move, counted on through full turns.
std::vector<double> ends_of_b(const Outcome& outcome) {
    std::vector<double> ends;
    for (std::size_t i = 0; i < outcome.moves.size(); ++i) ends.push_back(outcome.to(i, 'B'));
    return ends;
}

void expect_b(std::string_view gcode, const Conditions& conditions,
              const std::vector<double>& expected_value) {
    const Outcome outcome = run(gcode, conditions);
    ASSERT_TRUE(outcome.completed()) << outcome.message();
    const std::vector<double> ends = ends_of_b(outcome);
    ASSERT_EQ(ends.size(), expected_value.size()) << gcode;
    for (std::size_t i = 0; i < expected_value.size(); ++i)
        EXPECT_NEAR(ends[i], expected_value[i], 1e-9) << gcode << " move " << i;
}

TEST(RotaryMode, LimitedAxisCountsFullTurns) {
    const Conditions limited = with_turning(machine::RotaryMode::limited, 1000);
    expect_b("G0 B370\nG0 B10\nG0 B-700\n", limited, {370, 10, -700});
    expect_alarm(run("G0 B1001\n", limited), 1, {"axis B", "1001"});
}

// The example of a Fanuc manual (B-63534EN, 20.2.1, roll-over): distances -150, -30, -80, +380, -840.
TEST(RotaryMode, ShortestModeFollowsRollOverFunction) {
    expect_b("G90 G0 B-150.0\nB540.0\nB-620.0\nG91 B380.0\nB-840.0\n",
             with_turning(machine::RotaryMode::shortest), {-150, -180, -260, 120, -720});
}

TEST(RotaryMode, HalfTurnIsPositive) {
    const Conditions shortest = with_turning(machine::RotaryMode::shortest);
    expect_b("G0 B180\nB0\nB-180\n", shortest, {180, 360, 540});
}

TEST(RotaryMode, ShortestModeStaysInRange) {
    const Conditions shortest = with_turning(machine::RotaryMode::shortest, 200);
    // From 170 to 190 and back by 180; 300 is out of range, and so is reached as -60.
    expect_b("G0 B170\nB-170\nB-60\n", shortest, {170, 190, -60});
    Conditions narrow = with_turning(machine::RotaryMode::shortest, 90);
    expect_alarm(run("G0 B80\nB150\n", narrow), 2, {"axis B", "150", "past its limit"});
}

TEST(RotaryMode, ShortestModeHoldsWithOffsetsAndRotation) {
    const Conditions shortest = with_turning(machine::RotaryMode::shortest);
    expect_b("G0 B350\nG52 B20\nG0 B0\nG53 G0 B10\n", shortest, {-10, 20, 10});
    expect_b("G0 B350\nG68 X0 Y0 R30\nG0 B340\n", shortest, {-10, -20});
}

TEST(RotaryMode, UnwindModeTurnsAsProgrammedAndForgetsFullTurns) {
    const Conditions unwind = with_turning(machine::RotaryMode::unwind);
    expect_b("G0 B730\nB0\nB350\nB-10\n", unwind, {730, 720, 1070, 710});
    expect_b("G0 B720\nG91 B10\nG90 B0\n", unwind, {720, 730, 720});
    // The readings that a program sees, and what it sets by them.
    expect_b("G0 B730\n#1=#5024\nG0 B[#1+1]\n#2=#5044\nB[#2+1]\n", unwind, {730, 731, 732});
    expect_b("G0 B730\nG92 B5\nG0 B6\n", unwind, {730, 731});
}

TEST(RotaryMode, HomePositionFollowsSameRule) {
    expect_b("G0 B700\nG28\n", with_turning(machine::RotaryMode::shortest), {-20, 0});
    expect_b("G0 B730\nG28\nG27\n", with_turning(machine::RotaryMode::unwind), {730, 720});
    expect_b("G0 B730\nG28\nG27\n", with_turning(machine::RotaryMode::limited), {730, 0});
}

TEST(OtherHomePositions, ComeFromMachineFileIfMachineDataHasNone) {
    Conditions conditions;
    for (machine::Axis& axis : conditions.machine.axes) axis.other_homes[0] = axis.letter == 'Z' ? 50 : 20;
    conditions.options.data.homes[2] = {{'X', 100}};
    expect_end(run("G30\n", conditions), 100, 20, 50, 20, 20);
    expect_alarm(run("G30 P3\n", conditions), 1, {"home position 3 is not defined"});
    Script script = Script::from_text("local _ENV = require \"gsim.rs274ngc\" G30()", "part.lua", 0);
    script.dialect = conditions.options.dialect = "rs274ngc";
    expect_end(run_script(std::move(script), conditions), 100, 20, 50, 20, 20);
}

}  // namespace
}  // namespace gsim::script::turning_test
