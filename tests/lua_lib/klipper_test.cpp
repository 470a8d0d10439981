// The dialect klipper on machines of samples/.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "machine/file/machine_file.h"
#include "tests/lua_lib/run.h"
#include "tests/support/machine_path.h"

namespace gsim::script::klipper_test {
namespace {

constexpr double kEqualTolerance = 1e-9;

Conditions on(const std::string& machine) {
    Conditions setup;
    setup.machine = machine::load_machine(tests::machine_path("klipper-" + machine + ".toml")).value();
    setup.options.dialect = "klipper";
    return setup;
}

Outcome klipper(const std::string& gcode, const std::string& machine = "router") {
    return run(gcode, on(machine));
}

double run_time_s(const std::string& gcode, const std::string& machine = "router") {
    const Outcome outcome = klipper(gcode, machine);
    EXPECT_TRUE(outcome.completed()) << outcome.message();
    return outcome.report.cycle_time_s;
}

TEST(KlipperMoves, G0MovesLikeG1AndKeepsF) {
    EXPECT_NEAR(run_time_s("G1 X100 F6000\nG0 X200\n"), 2.1, kEqualTolerance);
    EXPECT_NEAR(run_time_s("G0 X100\n"), 100.0 / 25 + 25.0 / 1000, kEqualTolerance);  // before any F
}

TEST(KlipperMoves, AcceptIncrementsAndNewCoordinates) {
    const Outcome outcome = klipper("G1 X10 F600\nG91\nG1 X5 Y2\nG90\nG1 Z1\nG92 X0\nG1 X-5\n");
    ASSERT_TRUE(outcome.completed()) << outcome.message();
    EXPECT_NEAR(outcome.to(1, 'X'), 15, kEqualTolerance);
    EXPECT_NEAR(outcome.to(1, 'Y'), 2, kEqualTolerance);
    EXPECT_NEAR(outcome.to(3, 'X'), 10, kEqualTolerance);
}

TEST(KlipperMoves, G92DoesNotStopAndM400Does) {
    EXPECT_NEAR(run_time_s("G1 X50 F6000\nG92 X0\nG1 X50\n"), 1.1, kEqualTolerance);
    EXPECT_NEAR(run_time_s("G1 X50 F6000\nM400\nG1 X100\n"), 1.2, kEqualTolerance);
}

TEST(KlipperMoves, G4TakesMilliseconds) {
    EXPECT_NEAR(run_time_s("G1 X50 F6000\nG4 P123.4\nG1 X100\n"), 1.2 + 0.1234, kEqualTolerance);
    EXPECT_NEAR(run_time_s("G1 X50 F6000\nG4 S2\nG1 X100\n"), 1.2, kEqualTolerance);
}

TEST(KlipperMoves, MotorsOffTakesTwoTenthsAndRejectsMoves) {
    EXPECT_NEAR(run_time_s("G1 X100 F6000\nM84\nG1 X100\n"), 1.1 + 0.2, kEqualTolerance);
    expect_alarm(klipper("G1 X100 F6000\nM18\nG1 X0\n"), 3, {"homing"});
}

TEST(KlipperMoves, SpeedFactorAppliesToPreviousAndNextF) {
    EXPECT_NEAR(run_time_s("G1 X0 F6000\nM220 S50\nG1 X100\n"), 100.0 / 50 + 50.0 / 1000, kEqualTolerance);
    EXPECT_NEAR(run_time_s("M220 S50\nG1 X100 F6000\n"), 100.0 / 50 + 50.0 / 1000, kEqualTolerance);
}

TEST(KlipperLimits, ApplyToFollowingLines) {
    EXPECT_NEAR(run_time_s("M204 S500\nG1 X100 F6000\n"), 1 + 100.0 / 500, kEqualTolerance);
    EXPECT_NEAR(run_time_s("M204 P800 T400\nG1 X100 F6000\n"), 1 + 100.0 / 400, kEqualTolerance);
    EXPECT_NEAR(run_time_s("SET_VELOCITY_LIMIT VELOCITY=50\nG1 X100 F6000\n"), 2.05, kEqualTolerance);
    EXPECT_NEAR(run_time_s("SET_VELOCITY_LIMIT MINIMUM_CRUISE_RATIO=0\nG1 X3 F6000\n"),
                2 * std::sqrt(3.0 / 1000), kEqualTolerance);
    const Outcome corner = klipper("SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=8\nG1 X50 F6000\nG1 Y50\n");
    EXPECT_NEAR(corner.segments.at(0).master.end_speed(), 8, kEqualTolerance);
}

TEST(KlipperLimits, M204RequiresBothPAndT) {
    const Outcome outcome = klipper("M204 P500\nG1 X100 F6000\n");
    EXPECT_NEAR(outcome.report.cycle_time_s, 1.1, kEqualTolerance);
    EXPECT_EQ(outcome.report.messages.warnings.size(), 1u);
}

TEST(KlipperArcs, AreSplitIntoChordsOfResolution) {
    const Outcome outcome = klipper("G1 X10 F6000\nG3 X-10 Y0 I-10 J0\n", "router-arc1");
    ASSERT_TRUE(outcome.completed()) << outcome.message();
    EXPECT_EQ(outcome.moves.size(), 1u + 31u);  // 31.4 mm
    EXPECT_NEAR(outcome.to(16, 'Y'), 10 * std::sin(16 * std::numbers::pi / 31), 1e-9);
    EXPECT_NEAR(outcome.to(31, 'X'), -10, kEqualTolerance);
}

// XZ is counted from X to Z, so that G2 there is G3 of RS274.
TEST(KlipperArcs, G18ReversesDirection) {
    const Outcome outcome = klipper("G18\nG1 X10 F6000\nG2 X0 Z-10 I-10 K0\n", "fast-arc1");
    ASSERT_TRUE(outcome.completed()) << outcome.message();
    EXPECT_EQ(outcome.moves.size(), 1u + 15u);  // a quarter
    EXPECT_LT(outcome.to(1, 'Z'), 0);
}

TEST(KlipperArcs, RejectsUnsupportedArcsUnitsAndFeed) {
    expect_alarm(klipper("G1 X10 F600\nG91\nG2 X5 I2\n"), 3, {"[mode]", "G2", "not support arcs in G91"});
    expect_alarm(klipper("G1 X10 F600\nG2 X5 R5\n"), 2, {"[arc]", "G2", "not support arcs by R"});
    expect_alarm(klipper("G1 X10 F600\nG2 X5\n"), 2, {"I and J"});
    expect_alarm(klipper("G20\n"), 1, {"[mode]", "G20", "not support inches"});
    expect_alarm(klipper("G1 X5 F0\n"), 1, {"[feed]", "F0", "greater than 0"});
}

TEST(KlipperArcs, HaveNoEffectWithoutResolution) {
    const Outcome outcome = klipper("G1 X10 F6000\nG3 X-10 I-10\nG1 Y5\n", "fast-noarcs");
    ASSERT_TRUE(outcome.completed()) << outcome.message();
    EXPECT_EQ(outcome.moves.size(), 2u);
    EXPECT_EQ(outcome.report.messages.warnings.size(), 1u);
}

TEST(KlipperExtruder, RejectsEWithoutExtruder) {
    expect_alarm(klipper("G1 X10 E1 F600\n"), 1, {"no extruder"});
    EXPECT_TRUE(klipper("G1 X10 E0 F600\n").completed());
}

TEST(KlipperExtruder, AcceptsAbsoluteAndIncrementalE) {
    const Outcome steps = klipper("M83\nG1 X10 E1 F600\nG1 X20 E1\n", "fast-ext");
    ASSERT_TRUE(steps.completed()) << steps.message();
    EXPECT_NEAR(steps.to(1, 'E'), 2, kEqualTolerance);
    const Outcome absolute = klipper("G1 X10 E1 F600\nG92 E0\nG1 X20 E1\nM221 S50\nG1 X30 E2\n", "fast-ext");
    ASSERT_TRUE(absolute.completed()) << absolute.message();
    EXPECT_NEAR(absolute.to(1, 'E'), 2, kEqualTolerance);
    EXPECT_NEAR(absolute.to(2, 'E'), 2.5, kEqualTolerance);
}

TEST(KlipperExtruder, MoveOfEAloneUsesExtruderAcceleration) {
    const Outcome outcome = klipper("G1 E20 F600\n", "fast-ext");
    ASSERT_TRUE(outcome.completed()) << outcome.message();
    EXPECT_NEAR(outcome.report.cycle_time_s, 20.0 / 10 + 10 / outcome.machine.axes[3].max_acceleration,
                kEqualTolerance);
}

TEST(KlipperRetraction, RetractsOnceAndUnretractsSameLength) {
    const Outcome outcome = klipper("G11\nG1 X10 E1 F600\nG10\nG10\nG1 X20\nG11\nG1 X30 E2\n", "fast-ext-fw");
    ASSERT_TRUE(outcome.completed()) << outcome.message();
    ASSERT_EQ(outcome.moves.size(), 5u);
    EXPECT_NEAR(outcome.to(1, 'E'), 1 - 0.8, kEqualTolerance);
    EXPECT_NEAR(outcome.to(3, 'E'), 1, kEqualTolerance);
    EXPECT_NEAR(outcome.to(4, 'E'), 2, kEqualTolerance);
    const double a = outcome.machine.axes[3].max_acceleration;
    EXPECT_NEAR(outcome.seconds(1), trapezoid_s(0.8, std::min(35.0, std::sqrt(0.8 * a)), a), 0.02);
}

TEST(KlipperStates, AreSavedAndRestored) {
    const Outcome outcome = klipper(
        "G1 X10 F600\nSAVE_GCODE_STATE NAME=a\nG91\nG92 X0\nG1 X5 F6000\n"
        "RESTORE_GCODE_STATE NAME=a MOVE=1 MOVE_SPEED=50\nG1 X20\n");
    ASSERT_TRUE(outcome.completed()) << outcome.message();
    EXPECT_NEAR(outcome.to(2, 'X'), 10, kEqualTolerance);
    EXPECT_NEAR(outcome.segments.at(2).master.peak_speed(), 50, kEqualTolerance);
    EXPECT_NEAR(outcome.to(3, 'X'), 20, kEqualTolerance);
    EXPECT_NEAR(outcome.segments.at(3).master.peak_speed(), 10, kEqualTolerance);
    expect_alarm(klipper("RESTORE_GCODE_STATE NAME=b\n"), 1,
                 {"[mode]", "RESTORE_GCODE_STATE", "unknown state 'b'"});
}

TEST(KlipperStates, OffsetShiftsCoordinatesAndMovesToolIfRequested) {
    const Outcome outcome = klipper(
        "G1 X10 F600\nSET_GCODE_OFFSET X=2\nG1 X10\nSET_GCODE_OFFSET X_ADJUST=1 Z=1 MOVE=1\nG1 X0 Z0\n");
    ASSERT_TRUE(outcome.completed()) << outcome.message();
    EXPECT_NEAR(outcome.to(1, 'X'), 12, kEqualTolerance);
    EXPECT_NEAR(outcome.to(2, 'X'), 13, kEqualTolerance);
    EXPECT_NEAR(outcome.to(2, 'Z'), 1, kEqualTolerance);
    EXPECT_NEAR(outcome.to(3, 'X'), 3, kEqualTolerance);
    EXPECT_NEAR(outcome.to(3, 'Z'), 1, kEqualTolerance);
}

// M2 and similar words have no effect: the file continues.
TEST(KlipperWords, IgnoresUnknownWords) {
    EXPECT_NEAR(run_time_s("G1 X50 F6000\nM2\nM3 S1000\nT1\nG54\nX70\nG1 X100\n"), 1.1, kEqualTolerance);
}

}  // namespace
}  // namespace gsim::script::klipper_test
