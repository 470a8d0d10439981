// Feed, dwell, switches and home: times from the laws of motion, worked out by hand.

#include <cmath>
#include <numbers>

#include "tests/lua_lib/run.h"

namespace gsim::script::feed_test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Feed, SetsSpeedPerMinute) {
    const Outcome r = run("G1 X100 F6000\n");  // 100 mm/s
    EXPECT_NEAR(r.seconds(0), trapezoid_s(100, 100, kAcceleration_mm_s2), 1e-9);
    EXPECT_NEAR(r.moves[0].info.feed_per_min, 6000, 1e-9);
}

TEST(Feed, KeepsItsProgrammedUnit) {
    const Outcome r = run("G20 G1 X1 F100\nG21 X125.4\nG20 G1 X2 F50\n");
    EXPECT_NEAR(r.moves[0].info.feed_per_min, 2540, 1e-9);
    EXPECT_NEAR(r.moves[1].info.feed_per_min, 2540, 1e-9);
    EXPECT_NEAR(r.moves[2].info.feed_per_min, 1270, 1e-9);
    EXPECT_NEAR(r.seconds(1), trapezoid_s(100, 2540 / 60.0, kAcceleration_mm_s2), 1e-9);
}

TEST(Feed, IsLimitedToContourSpeedWithWarning) {
    const Outcome r = run("G1 X1000 F30000\n");
    EXPECT_NEAR(r.seconds(0), trapezoid_s(1000, kFeed_mm_s, kAcceleration_mm_s2), 1e-9);
    ASSERT_EQ(r.report.messages.warnings.size(), 1U);
    EXPECT_NE(r.report.messages.warnings[0].find("15240"), std::string::npos)
        << r.report.messages.warnings[0];
}

TEST(Feed, RotaryAxesAloneUseDegreesPerMinute) {
    EXPECT_NEAR(run("G1 B90 F600\n").seconds(0), trapezoid_s(90, 10, kTurn_deg_s2), 1e-9);
    EXPECT_NEAR(run("G20 G1 B90 F600\n").seconds(0), trapezoid_s(90, 10, kTurn_deg_s2),
                1e-9);  // not in inches
}

TEST(Feed, SlowerOfLinearAndRotaryAxesLimitsMove) {
    EXPECT_NEAR(run("G1 X10 B180 F6000\n").seconds(0), trapezoid_s(180, kTurn_deg_s, kTurn_deg_s2), 1e-9);
    EXPECT_NEAR(run("G1 X500 B1 F6000\n").seconds(0), trapezoid_s(500, 100, kAcceleration_mm_s2), 1e-9);
}

TEST(Feed, InverseTimeSetsDurationOfLinesAndArcs) {
    EXPECT_NEAR(run("G93 G1 X100 F12\n").seconds(0), 5, 1e-9);  // 60/F s
    const Outcome arc = run("G0 X100 Y100\nG93 G3 X90 Y110 I-10 F20\n");
    EXPECT_NEAR(arc.seconds(1), kPi / 2 * 3, 1e-9);  // angle * 60/F s
    const Outcome via = run("G0 X100 Y100\nG93 CIP X120 Y100 I1=110 J1=110 F30\n");
    EXPECT_NEAR(via.seconds(1), kPi * 2, 1e-7);
    const Outcome long_way = run("G0 X100 Y100\nG93 G2 X90 Y110 I-10 F20\n");
    EXPECT_NEAR(long_way.seconds(1), 1.5 * kPi * 3, 1e-9);
}

TEST(Feed, TooShortInverseTimeIsRaisedToLimits) {
    const Outcome r = run("G93 G1 X254 F600\n");
    EXPECT_NEAR(r.seconds(0), trapezoid_s(254, kFeed_mm_s, kAcceleration_mm_s2), 1e-9);
    EXPECT_EQ(r.report.messages.warnings.size(), 1U);
}

TEST(Feed, InverseTimeRequiresFInEachBlock) {
    expect_alarm(run("G93 G1 X10 F60\nX20\n"), 2, {"G93", "F"});
}

TEST(Feed, IsNotReusedInOtherMode) {
    expect_alarm(run("G94 G1 X10 F600\nG95 S100 X20\n"), 2, {"no feed"});
    expect_alarm(run("G93 G1 X10 F60\nG94 X20\n"), 2, {"no feed"});
}

TEST(Feed, PerRevolutionRequiresSpindleSpeed) {
    EXPECT_NEAR(run("G95 S600 G1 X100 F2\n").seconds(0), trapezoid_s(100, 20, kAcceleration_mm_s2), 1e-9);
    expect_alarm(run("G95 G1 X10 F2\n"), 1, {"spindle speed"});
}

TEST(Feed, RejectsMissingOrNonPositiveValue) {
    expect_alarm(run("G0 X1\nG1 X10\n"), 2, {"no feed"});
    expect_alarm(run("G1 X10 F0\n"), 1, {"F", "above 0"});
    expect_alarm(run("G1 X10 F-5\n"), 1, {"-5"});
}

TEST(Feed, RapidRequiresNoFeed) {
    const Outcome r = run("G0 X1000\n");
    EXPECT_NEAR(r.seconds(0), trapezoid_s(1000, 508, kAcceleration_mm_s2), 1e-9);
    EXPECT_NEAR(r.report.distances.rapid_mm, 1000, 1e-9);
    EXPECT_DOUBLE_EQ(r.report.distances.feed_mm, 0);
}

TEST(Dwell, AcceptsSecondsInPXOrU) {
    const Outcome r = run("G4 P1.5\nG4 X2\nX5 G04\nG4 U.25\n");
    ASSERT_EQ(r.moves.size(), 4U) << r.message();
    EXPECT_NEAR(r.seconds(0), 1.5, 1e-9);
    EXPECT_NEAR(r.seconds(1), 2, 1e-9);
    EXPECT_NEAR(r.seconds(2), 5, 1e-9);
    EXPECT_NEAR(r.report.times.dwell_s, 8.75, 1e-9);
    EXPECT_NEAR(r.report.cycle_time_s, 8.75, 1e-9);
    expect_end(r, 0, 0, 0);
}

TEST(Dwell, RejectsNegativeTime) {
    expect_alarm(run("G4 P-1\n"), 1, {"-1"});
}

TEST(Switches, AreReportedAtTheirTimes) {
    const Outcome r = run("G1 X100 F6000\nM8\nX200\nM9\nM10\nM11\nM3 S100\nM5\nM0\nM1\nT5 M6\nM2\n");
    EXPECT_EQ(r.events(),
              "jet_on jet_off abrasive_on abrasive_off spindle_cw spindle_off stop optional_stop tool_select "
              "tool_change");
    EXPECT_NEAR(r.report.events[0].t_s, r.moves[0].end_s, 1e-9);
    EXPECT_EQ(r.report.events[0].location.line, 2U);
    EXPECT_NEAR(r.report.events[1].t_s, r.moves[1].end_s, 1e-9);
}

TEST(Switches, SumLengthWithProcessOn) {
    const Outcome r = run("F6000 G1 X100\nM8\nX130 Y40\nG3 X120 Y50 I-10\nM9\nX300\nG0 X0\n");
    EXPECT_NEAR(r.report.distances.process_on_mm, 50 + 5 * kPi, 1e-9);
    EXPECT_FALSE(r.moves[0].info.process_on);
    EXPECT_TRUE(r.moves[2].info.process_on);
}

TEST(Switches, CuttingModeWarnsOnce) {
    const Outcome r = run("G64\nG64\nG61\nG9 G1 X1 F100\n");
    EXPECT_TRUE(r.completed()) << r.message();
    EXPECT_EQ(r.report.messages.warnings.size(), 1U);
}

TEST(Home, G28AndG29PassIntermediatePoint) {
    const Outcome r = run("F1000 G0 X100 Y100 Z50\nG28 X120 Y80\nG29 X10 Y20\n");
    ASSERT_EQ(r.moves.size(), 5U) << r.message();
    EXPECT_NEAR(r.to(1, 'X'), 120, 1e-9);
    EXPECT_NEAR(r.to(1, 'Y'), 80, 1e-9);
    EXPECT_NEAR(r.to(2, 'X'), 0, 1e-9);
    EXPECT_NEAR(r.to(2, 'Z'), 50, 1e-9);  // Z was not named
    EXPECT_NEAR(r.to(3, 'X'), 120, 1e-9);
    expect_end(r, 10, 20, 50);
    EXPECT_EQ(r.moves[4].info.kind, simulation::MoveKind::rapid);
}

TEST(Home, BareG28MovesAllAxesHome) {
    expect_end(run("G0 X100 Y100 Z50 B20 C30\nG28\n"), 0, 0, 0, 0, 0);
}

TEST(Home, IncrementOfG28SelectsItsAxis) {
    expect_end(run("G0 X100 Y100\nG28 U0\n"), 0, 100, 0);
    expect_end(run("G0 X100 Y100\nG91 G28 X0 Y0\n"), 0, 0, 0);
}

TEST(Home, KeepsModalMotion) {
    const Outcome r = run("G1 X100 F6000\nG28 X100\nX50\n");
    EXPECT_EQ(r.moves.back().info.kind, simulation::MoveKind::linear);
}

TEST(Home, G27ChecksHomePosition) {
    EXPECT_TRUE(run("G0 X100\nG27 X0\n").completed());
    expect_alarm(run("G0 Y100\nG27 Y5\n"), 2, {"axis Y", "5", "home 0"});
}

}  // namespace
}  // namespace gsim::script::feed_test
