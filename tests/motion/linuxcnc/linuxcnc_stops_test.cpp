// Moves that end at standstill, and those that do not: G61.1, G61, single moves in G64, feed against rapid.

#include <gtest/gtest.h>

#include "tests/motion/linuxcnc/linuxcnc_run.h"
#include "tests/motion/segment_checks.h"

namespace gsim::motion::linuxcnc_stops_test {
namespace {

constexpr double kA = 490.3;
constexpr double kPeriod = 1e-3;

// Expects at most two periods more for each move than its trapezoid takes.
void expect_moves(double time_s, double trapezoids_s, int moves) {
    EXPECT_GE(time_s, trapezoids_s - 1e-9);
    EXPECT_LE(time_s, trapezoids_s + 2 * moves * kPeriod);
}

void square(LinuxcncRun& run) {
    for (const auto& [x, y] : {std::pair(100, 0), {100, 100}, {0, 100}, {0, 0}}) ASSERT_TRUE(run.line(x, y));
}

TEST(LinuxcncStops, ExactStopGivesTrapezoidPerBlock) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::exact_stop;
    run.next.rules.programmed_speed_mm_s = 254;
    square(run);
    expect_moves(run.end(), 4 * trapezoid_s(100, 254, kA), 4);
    ASSERT_EQ(run.segments.size(), 4u);
    expect_chain(run);
}

TEST(LinuxcncStops, ExactPathStopsAtCornersAtNineTenthsAcceleration) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::exact_path;
    run.next.rules.programmed_speed_mm_s = 254;
    square(run);
    expect_moves(run.end(), 4 * trapezoid_s(100, 254, 0.9 * kA), 4);
}

TEST(LinuxcncStops, DiagonalHasLimitsOfBothAxes) {
    LinuxcncRun run(fast_machine());
    run.next.rapid = true;
    ASSERT_TRUE(run.line(300, 400));
    expect_moves(run.end(), trapezoid_s(500, 508 * 500 / 400.0, kA * 500 / 400), 1);
    EXPECT_EQ(run.segments[0].limited_by, (LimitCause{LimitKind::acceleration, 1}));
}

TEST(LinuxcncStops, LastMoveInContinuousModeHasHalfAcceleration) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::continuous;
    run.next.rules.programmed_speed_mm_s = 254;
    ASSERT_TRUE(run.line(1000, 0));
    expect_moves(run.end(), trapezoid_s(1000, 254, kA / 2), 1);
    EXPECT_EQ(run.segments[0].limited_by, (LimitCause{LimitKind::feed, -1}));
}

TEST(LinuxcncStops, CentripetalAccelerationReducesThatAlongArc) {
    for (const auto mode : {rrs::PathMode::exact_path, rrs::PathMode::continuous}) {
        LinuxcncRun run(fast_machine());
        run.next.mode = mode;
        run.next.rules.programmed_speed_mm_s = 254;
        ASSERT_TRUE(run.arc(20, 0, 2 * kPi));
        const double speed = std::sqrt(std::sqrt(0.75) * kA * 20);
        const double along = mode == rrs::PathMode::continuous ? kA / 4 : kA / 2;
        expect_moves(run.end(), trapezoid_s(2 * kPi * 20, speed, along), 1);
        EXPECT_EQ(run.segments[0].kind, SegmentKind::circular);
        EXPECT_EQ(run.segments[0].limited_by.kind, LimitKind::centripetal);
    }
}

TEST(LinuxcncStops, ArcBeforeLineUsesAccelerationLeftByTopSpeed) {
    // The axes' speed counts, not the programmed one.
    PlannerSetup machine = fast_machine();
    for (int axis = 0; axis < 3; ++axis) machine.joints[static_cast<std::size_t>(axis)].max_speed = 100;
    LinuxcncRun run(machine);
    run.next.mode = rrs::PathMode::exact_stop;
    run.next.rules.programmed_speed_mm_s = 50;
    ASSERT_TRUE(run.arc(50, 0, kPi));
    ASSERT_TRUE(run.line(100, -100));
    run.end();
    const double across = 100 * 100 / 50.0 / kA;
    const double arc_s = trapezoid_s(kPi * 50, 50, kA * std::sqrt(1 - across * across));
    expect_moves(run.segments[0].duration_s, arc_s, 1);
}

TEST(LinuxcncStops, StopsBetweenRapidAndFeed) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::continuous;
    ASSERT_TRUE(run.line(100, 0));
    run.next.rapid = true;
    ASSERT_TRUE(run.line(200, 0));
    run.next.rapid = false;
    ASSERT_TRUE(run.line(300, 0));
    run.end();
    ASSERT_EQ(run.segments.size(), 3u);
    for (const Segment& segment : run.segments) EXPECT_NEAR(segment.master.end_speed(), 0, 1e-6);
    // The moves have no blend: the acceleration is full, except for the last move.
    expect_moves(run.segments[0].duration_s, trapezoid_s(100, 100, kA), 1);
    expect_moves(run.segments[1].duration_s, trapezoid_s(100, 508, kA), 1);
    expect_moves(run.segments[2].duration_s, trapezoid_s(100, 100, kA / 2), 1);
}

TEST(LinuxcncStops, ReversalStopsAtFullAcceleration) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::exact_path;
    ASSERT_TRUE(run.line(100, 0));
    ASSERT_TRUE(run.line(0, 0));
    expect_moves(run.end(), 2 * trapezoid_s(100, 100, kA), 2);
}

TEST(LinuxcncStops, RotaryJointsLimitPureAndMixedMoves) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::exact_path;
    rrs::JointPos joints = run.next.start;
    joints[3] = 1;
    joints[4] = 0.75;
    run.next.rules.orientation_speed_rad_s = 0.5;
    ASSERT_TRUE(run.go(joints));
    run.end();
    // The norm has 1.25 rad; B, which moves farthest, limits its acceleration.
    expect_moves(run.segments[0].duration_s, trapezoid_s(1.25, 0.5, 1.25 * kPi / 9), 1);
    EXPECT_EQ(run.segments[0].length_mm, 0);
    joints[0] = 100;
    joints[3] = 2;
    ASSERT_TRUE(run.go(joints));
    run.end();
    expect_moves(run.segments[1].duration_s, trapezoid_s(100, 100, 100 * kPi / 9), 1);
    EXPECT_EQ(run.segments[1].limited_by.kind, LimitKind::acceleration);
    EXPECT_EQ(run.segments[1].limited_by.joint, 3);
}

TEST(LinuxcncStops, InverseTimeSetsSpeedAndRampsAddTime) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::exact_path;
    run.next.rules.min_duration_s = 2;
    run.next.rules.programmed_speed_mm_s = 0;
    ASSERT_TRUE(run.line(100, 0));
    expect_moves(run.end(), 2 + 50 / kA, 1);
    EXPECT_EQ(run.segments[0].limited_by.kind, LimitKind::time);
}

TEST(LinuxcncStops, TimesAreExactWithoutServoPeriod) {
    LinuxcncRun run(fast_machine(), 0);
    run.next.mode = rrs::PathMode::exact_stop;
    square(run);
    EXPECT_NEAR(run.end(), 4 * trapezoid_s(100, 100, kA), 1e-9);
}

}  // namespace
}  // namespace gsim::motion::linuxcnc_stops_test
