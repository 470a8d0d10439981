// Inputs that the model rejects, and values of no real machine.

#include <limits>

#include <gtest/gtest.h>

#include "tests/motion/linuxcnc/linuxcnc_run.h"

namespace gsim::motion::linuxcnc_limits_test {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(LinuxcncLimits, RejectsMoveWithoutSpeed) {
    for (const double speed : {0.0, -1.0, kNan}) {
        LinuxcncRun run(fast_machine());
        run.next.rules.programmed_speed_mm_s = speed;
        const PlanResult planned = run.line(10, 0);
        ASSERT_FALSE(planned);
        EXPECT_EQ(planned.error().status, rrs::Status::RRS_ZERO_SPEED);
        EXPECT_EQ(run.end(), 0);
        run.next.rapid = true;
        EXPECT_TRUE(run.line(10, 0));
        EXPECT_GT(run.end(), 0);
    }
}

TEST(LinuxcncLimits, RejectsNonFiniteAndHugeValues) {
    LinuxcncRun run(fast_machine());
    for (const double x : {kNan, kInf, -kInf, 1e300}) {
        const PlanResult planned = run.line(x, 0);
        ASSERT_FALSE(planned) << x;
        EXPECT_EQ(planned.error().status, rrs::Status::RRS_INVALID_PARAMETER);
    }
    run.next.rules.programmed_speed_mm_s = 1e-12;
    const PlanResult slow = run.line(100, 0);
    ASSERT_FALSE(slow);
    EXPECT_EQ(slow.error().status, rrs::Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(run.end(), 0);
}

TEST(LinuxcncLimits, RejectedMoveKeepsPendingMoves) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::continuous;
    ASSERT_TRUE(run.line(10, 0));
    EXPECT_FALSE(run.line(kNan, 0));
    ASSERT_TRUE(run.line(20, 0));
    run.end();
    EXPECT_EQ(run.segments.back().target_id, 2);
    expect_chain(run);
}

TEST(LinuxcncLimits, IgnoresMovesWithoutDistance) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::exact_path;
    ASSERT_TRUE(run.line(0, 0));
    EXPECT_EQ(run.end(), 0);
    ASSERT_TRUE(run.line(100, 0));
    ASSERT_TRUE(run.line(100, 0));
    ASSERT_TRUE(run.line(200, 0));
    run.end();
    ASSERT_EQ(run.segments.size(), 2u);
    EXPECT_GT(run.segments[0].master.end_speed(), 0);
}

TEST(LinuxcncLimits, ClearDropsAndStandstillEmitsPendingMoves) {
    LinuxcncRun run(fast_machine());
    run.model.plan_to_standstill();
    ASSERT_TRUE(run.line(10, 0));
    EXPECT_TRUE(run.segments.empty());
    run.model.clear();
    EXPECT_EQ(run.end(), 0);
    ASSERT_TRUE(run.line(20, 0));
    run.end();
    EXPECT_EQ(run.segments.size(), 1u);
}

TEST(LinuxcncLimits, RunAfterStandstillTakesSameTime) {
    LinuxcncRun run(fast_machine());
    run.next.mode = rrs::PathMode::continuous;
    ASSERT_TRUE(run.line(10, 0));
    const double first_s = run.end();
    for (int i = 2; i <= 5; ++i) {
        ASSERT_TRUE(run.line(10 * i, 0));
        EXPECT_NEAR(run.end(), i * first_s, 1e-9);
    }
}

TEST(LinuxcncLimits, PlansMachinesWithoutLimits) {
    for (const double servo_period_s : {1e-3, 0.0, 1e-300, kInf}) {
        for (const double speed : {100.0, kInf, 1e-3}) {
            PlannerSetup machine = fast_machine();
            for (JointSetup& joint : machine.joints) joint.max_speed = joint.max_acceleration = kInf;
            LinuxcncRun run(machine, servo_period_s == kInf ? 1e-3 : servo_period_s);
            run.next.mode = rrs::PathMode::continuous;
            run.next.rules.programmed_speed_mm_s = speed;
            for (int i = 0; i < 200; ++i) ASSERT_TRUE(run.line(i % 7, (i * i) % 5));
            ASSERT_TRUE(run.arc(50, 50, 3));
            const double time_s = run.end();
            EXPECT_TRUE(std::isfinite(time_s));
            EXPECT_GE(time_s, 0);
            expect_chain(run);
        }
    }
}

TEST(LinuxcncLimits, PlansHugeAndTinyMoves) {
    for (const double scale : {1e-8, 1e-4, 1e6}) {
        LinuxcncRun run(fast_machine());
        run.next.mode = rrs::PathMode::continuous;
        for (int i = 1; i < 50; ++i) ASSERT_TRUE(run.line(scale * i, scale * (i % 4) * (i % 3)));
        EXPECT_TRUE(std::isfinite(run.end()));
        EXPECT_GE(run.segments.back().target_id, scale < 1e-7 ? 40 : 49) << "the shortest are made together";
        EXPECT_NEAR(run.segments.back().end[0], scale * 49, 1e-7 + 1e-9 * scale);
    }
}

}  // namespace
}  // namespace gsim::motion::linuxcnc_limits_test
