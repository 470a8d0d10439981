// Tangent runs: their speed, the range of the look-ahead, and the number of pending moves.

#include <gtest/gtest.h>

#include "tests/motion/linuxcnc/linuxcnc_run.h"

namespace gsim::motion::linuxcnc_look_ahead_test {
namespace {

constexpr double kA = 490.3;

double top_speed(const LinuxcncRun& run) {
    double top = 0;
    for (const Segment& segment : run.segments) top = std::max(top, segment.master.peak_speed());
    return top;
}

void straight_run(LinuxcncRun& run, int count, double length_mm) {
    for (int i = 1; i <= count; ++i) ASSERT_TRUE(run.line(i * length_mm, 0));
}

TEST(LinuxcncLookAhead, EntersLastLineAbleToStopInHalf) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::exact_path;
    run.next.rules.programmed_speed_mm_s = 254;
    straight_run(run, 2, 100);
    run.end();
    ASSERT_EQ(run.segments.size(), 2u);
    EXPECT_NEAR(run.segments[0].master.end_speed(), std::sqrt(kA * 100), 1e-6);
    EXPECT_NEAR(run.segments[1].master.start_speed(), std::sqrt(kA * 100), 1e-6);
    EXPECT_LE(run.segments[1].master.end_speed(), 1e-6);
}

TEST(LinuxcncLookAhead, DepthLimitsSpeedOfLongRun) {
    constexpr double kLength_mm = 0.5;
    for (const int depth : {5, 20, 50}) {
        LinuxcncRun run(fast_machine(), 1e-3, static_cast<std::size_t>(depth));
        run.next.mode = rrs::PathMode::exact_path;
        run.next.rules.programmed_speed_mm_s = 500;
        straight_run(run, 1000, kLength_mm);
        run.end();
        expect_chain(run);
        // After a junction `depth - 1` lines count fully and one by half.
        const double seen_mm = (depth - 0.5) * kLength_mm;
        EXPECT_LE(top_speed(run), std::sqrt(2 * kA * (seen_mm + kLength_mm)));
        EXPECT_GE(top_speed(run), std::sqrt(2 * kA * seen_mm) * (1 - 1e-9));
        EXPECT_EQ(run.segments[500].limited_by.kind, LimitKind::look_ahead);
    }
}

// Each junction's speed lets the known path stop: v^2 / 2a is no more than the distance to the end.
TEST(LinuxcncLookAhead, CanAlwaysStopAtEnd) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::exact_path;
    run.next.rules.programmed_speed_mm_s = 300;
    straight_run(run, 200, 3);
    run.end();
    double left_mm = 600;
    for (const Segment& segment : run.segments) {
        ASSERT_LE(segment.master.start_speed(), std::sqrt(2 * kA * left_mm) * (1 + 1e-9));
        left_mm -= segment.length_mm;
    }
    EXPECT_NEAR(left_mm, 0, 1e-6);
}

TEST(LinuxcncLookAhead, ShortLinesTakeAtLeastOnePeriod) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::exact_path;
    run.next.rules.programmed_speed_mm_s = 300;
    straight_run(run, 2000, 0.05);
    run.end();
    EXPECT_LE(top_speed(run), 0.05 / 1e-3);
}

TEST(LinuxcncLookAhead, PassesSmallCornerAtReducedAcceleration) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::exact_path;
    ASSERT_TRUE(run.line(100, 0));
    // The corner at 100 mm/s by this angle within 1 ms takes some 4 % of the acceleration.
    ASSERT_TRUE(run.line(200, 100 * 2e-4));
    ASSERT_TRUE(run.line(200, 100));
    run.end();
    EXPECT_NEAR(run.segments[0].master.end_speed(), 100, 1e-6);
    EXPECT_NEAR(run.segments[1].master.end_speed(), 0, 1e-6);
    EXPECT_LT(run.segments[0].master.peak_acceleration(), kA);
    EXPECT_GT(run.segments[0].master.peak_acceleration(), 0.9 * kA);
}

TEST(LinuxcncLookAhead, ReachesSlowerFeedAtItsStart) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::exact_path;
    run.next.rules.programmed_speed_mm_s = 200;
    ASSERT_TRUE(run.line(200, 0));
    run.next.rules.programmed_speed_mm_s = 50;
    ASSERT_TRUE(run.line(400, 0));
    run.end();
    EXPECT_NEAR(run.segments[0].master.peak_speed(), 200, 1e-6);
    EXPECT_NEAR(run.segments[0].master.end_speed(), 50, 1e-6);
    EXPECT_NEAR(run.segments[1].master.peak_speed(), 50, 1e-6);
}

TEST(LinuxcncLookAhead, BuffersAtMostSixtyMoves) {
    for (const auto mode :
         {rrs::PathMode::exact_stop, rrs::PathMode::exact_path, rrs::PathMode::continuous}) {
        LinuxcncRun run(fast_machine());
        run.next.mode = mode;
        run.next.tolerance_mm = 0.01;
        rrs::TargetId pending = 0;
        for (int i = 1; i <= 3000; ++i) {
            ASSERT_TRUE(run.line(0.5 * i, 5 * std::sin(0.02 * i)));
            const rrs::TargetId out = run.segments.empty() ? 0 : run.segments.back().target_id;
            pending = std::max(pending, run.last_id - out);
        }
        EXPECT_LE(pending, 60);
        run.end();
        expect_chain(run);
        EXPECT_EQ(run.segments.back().target_id, 3000);
    }
}

TEST(LinuxcncLookAhead, BuffersFewParabolicBlends) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::continuous;
    rrs::JointPos joints = run.next.start;
    rrs::TargetId pending = 0;
    for (int i = 1; i <= 3000; ++i) {
        joints[0] = 0.2 * i;
        joints[1] = std::sin(i);
        joints[3] = i % 5 == 0 ? joints[3] : 0.05 * std::cos(i);
        ASSERT_TRUE(run.go(joints));
        const rrs::TargetId out = run.segments.empty() ? 0 : run.segments.back().target_id;
        pending = std::max(pending, run.last_id - out);
    }
    EXPECT_LE(pending, 10);
    run.end();
    expect_chain(run);
}

}  // namespace
}  // namespace gsim::motion::linuxcnc_look_ahead_test
