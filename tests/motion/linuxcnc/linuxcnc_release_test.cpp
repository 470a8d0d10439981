// Differences of the planner of LinuxCNC 2.10 from that of 2.9, with straight ramps.

#include <gtest/gtest.h>

#include "tests/motion/linuxcnc/linuxcnc_run.h"

namespace gsim::motion::linuxcnc_release_test {
namespace {

constexpr double kA = 1000, kV = 100;
constexpr double kPeriods_s = 2e-3;  // what counting in periods may cost a program
constexpr double kNormal = 0.86602540378443864676;

PlannerSetup router_2_9() {
    PlannerSetup setup = router_2_10();
    setup.controller.linuxcnc.release = rrs::LinuxcncRelease::v2_9;
    return setup;
}

double line_s(const PlannerSetup& setup, rrs::PathMode mode, double length_mm) {
    LinuxcncRun run(setup);
    run.next.mode = mode;
    EXPECT_TRUE(run.line(length_mm, 0));
    return run.end();
}

TEST(LinuxcncRelease, SingleLineUsesFullAccelerationIn210) {
    for (const double length_mm : {1.0, 10.0, 1000.0}) {
        const double exact_s = line_s(router_2_10(), rrs::PathMode::exact_path, length_mm);
        EXPECT_EQ(line_s(router_2_10(), rrs::PathMode::continuous, length_mm), exact_s);
        EXPECT_EQ(line_s(router_2_9(), rrs::PathMode::exact_path, length_mm), exact_s);
        EXPECT_GT(line_s(router_2_9(), rrs::PathMode::continuous, length_mm), exact_s);
    }
}

TEST(LinuxcncRelease, LookAheadUsesHalfAccelerationInContinuousMode) {
    for (const auto& [mode, share] :
         {std::pair{rrs::PathMode::exact_path, 1.0}, std::pair{rrs::PathMode::continuous, 0.5}}) {
        LinuxcncRun run(router_2_10());
        run.next.mode = mode;
        ASSERT_TRUE(run.line(20, 0));
        ASSERT_TRUE(run.line(24, 0));
        run.end();
        EXPECT_NEAR(run.segments[0].master.end_speed(), std::sqrt(share * kA * 4), 1e-6);
    }
}

double circle_s(double radius_mm, rrs::PathMode mode) {
    LinuxcncRun run(router_2_10());
    run.next.mode = mode;
    EXPECT_TRUE(run.arc(radius_mm, 0, 2 * kPi));
    return run.end();
}

// The ramps get the part of the acceleration that the speed of the axes leaves.
TEST(LinuxcncRelease, SingleCircleRampsUseRemainingAcceleration) {
    const double along = kA * std::sqrt(1 - std::pow(kV * kV / kA / 20, 2));
    EXPECT_NEAR(circle_s(20, rrs::PathMode::exact_path), 2 * kPi * 20 / kV + kV / along, kPeriods_s);
    EXPECT_NEAR(circle_s(20, rrs::PathMode::exact_path), 1.375, kPeriods_s + 1e-9);
}

// It is slowed for a half that it then does not have to share.
TEST(LinuxcncRelease, ArcsInContinuousModeAreSlowedAsIfBlended) {
    const double speed = std::sqrt(kNormal * kA / 2 * 10);
    EXPECT_NEAR(circle_s(10, rrs::PathMode::continuous), 2 * kPi * 10 / speed + speed / (kA / 2), kPeriods_s);
    const double exact = std::sqrt(kNormal * kA * 10);
    EXPECT_NEAR(circle_s(10, rrs::PathMode::exact_path), 2 * kPi * 10 / exact + exact / (kA / 2), kPeriods_s);
}

TEST(LinuxcncRelease, ParabolicBlendsTakeLessTimeThanStops) {
    double times_s[2];
    for (const auto mode : {rrs::PathMode::exact_stop, rrs::PathMode::continuous}) {
        LinuxcncRun run(router_2_10());
        run.next.mode = mode;
        rrs::JointPos joints = run.next.start;
        for (int i = 1; i <= 4; ++i) {
            joints[i % 2 == 0 ? 0 : 3] += i % 2 == 0 ? 30 : 0.3;
            ASSERT_TRUE(run.go(joints));
        }
        times_s[mode == rrs::PathMode::continuous ? 1 : 0] = run.end();
        expect_chain(run);
    }
    EXPECT_LT(times_s[1], times_s[0]);
    EXPECT_GT(times_s[1], times_s[0] / 2);
}

}  // namespace
}  // namespace gsim::motion::linuxcnc_release_test
