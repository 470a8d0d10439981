// Moves from standstill to standstill with S-curves, with other decelerations than accelerations, and with
// ramps that a program selects.

#include "tests/motion/law_reference.h"
#include "tests/motion/motion_checks.h"
#include "tests/motion/planner_under_test.h"

namespace gsim::motion::rest_ramps_test {
namespace {

using rrs::MotionType;
using rrs::RampLimit;
using rrs::RampMode;
using rrs::Status;

rrs::JointPos random_target(std::mt19937& random, int joints) {
    std::uniform_real_distribution<double> place(-60, 60);
    std::bernoulli_distribution moves(0.6);
    rrs::JointPos target = rrs::JointPos::Zero(joints);
    for (double& value : target) value = moves(random) ? place(random) : 0;
    return target;
}

double time_to(ReadyPlanner& ready, double x_mm) {
    const double before_s = ready.planner.time_s();
    EXPECT_EQ(ready.to(joint_pos({x_mm, 0, 0})), Status::RRS_SUCCESS) << ready.message();
    return ready.planner.time_s() - before_s;
}

TEST(RestToRestRamps, KeepLimitsInRandomMoves) {
    std::mt19937 random(11);
    for (int round = 0; round < 150; ++round) {
        PlannerSetup setup = odd_setup(random);
        set_ramps(setup, random, round % 3 != 0);
        ReadyPlanner ready(setup, rrs::JointPos::Zero(7));
        ready.planner.SetCartesianPositionSpeed(80);
        ready.planner.SelectMotionType(round % 2 == 0 ? MotionType::linear : MotionType::joint);
        for (int i = 0; i < 8; ++i) {
            if (i % 4 == 3) ready.planner.SetMotionTime(20);
            ASSERT_GE(static_cast<int>(ready.to(random_target(random, 7))), 0) << ready.message();
        }
        ready.planner.flush();
        expect_joined(ready.collector.segments);
        for (const Segment& segment : ready.collector.segments) {
            expect_segment_limits(segment, setup);
            for (const Follower& follower : segment.followers())
                ASSERT_NEAR(follower.law.duration_s(), segment.duration_s, 1e-9 * segment.duration_s);
            ASSERT_LT((segment.position_at(segment.duration_s * (1 - 1e-12)) - segment.end).norm(), 1e-6);
        }
        if (testing::Test::HasFatalFailure()) FAIL() << "round " << round;
    }
}

TEST(RestToRestRamps, TakeMinimumTime) {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> log_scale(-2, 2);
    for (int round = 0; round < 300; ++round) {
        PlannerSetup setup = three_slide_machine();
        set_ramps(setup, random, true);
        const JointSetup& x = setup.joints[0];
        ReadyPlanner ready(setup, joint_pos({0, 0, 0}));
        const double length = 20 * std::exp(log_scale(random));
        const LawCase full{length, 0, 0, {x.max_speed, x.max_acceleration, x.deceleration(), x.max_jerk}};
        const auto min_s = static_cast<double>(least_rest_to_rest_s(full));
        ASSERT_NEAR(time_to(ready, length), min_s, 1e-9 * min_s);
    }
}

TEST(RestToRestRamps, KeepLimitsIfStretchedToDuration) {
    std::mt19937 random(13);
    std::uniform_real_distribution<double> log_scale(-2, 2);
    for (int round = 0; round < 2000; ++round) {
        const LawLimits limits{100 * std::exp(log_scale(random)), 500 * std::exp(log_scale(random)),
                               500 * std::exp(log_scale(random)),
                               round % 4 == 0 ? kUnlimited : 9000 * std::exp(log_scale(random))};
        const double length = 30 * std::exp(log_scale(random));
        const double min_s = TimeLaw::between(length, 0, 0, limits).duration_s();
        const double section = round % 5 == 0 ? 1 : 1 + std::exp(3 * log_scale(random) - 3);
        const TimeLaw law = TimeLaw::with_duration(length, min_s * section, limits);
        EXPECT_EQ(law.duration_s(), min_s * section);
        const LawSection& last = law.sections().back();
        const double t = last.duration_s;
        ASSERT_NEAR(last.s0 + t * (last.v0 + t * (last.a0 / 2 + t * last.jerk / 6)), length, 1e-9 * length);
        expect_law_limits(law, limits);
    }
}

TEST(RestToRestRamps, InfiniteRampsJump) {
    ReadyPlanner ready(three_slide_machine(), joint_pos({0, 0, 0}));
    ready.planner.SetRampMode(RampMode::infinite);
    EXPECT_NEAR(time_to(ready, 50), 0.5, 1e-12);
    EXPECT_TRUE(ready.last().master.jumps());
}

class RampServices : public AnyPlanner {};
INSTANTIATE_TEST_SUITE_P(Ways, RampServices, all_ways(), way_name);

TEST_P(RampServices, ProgrammedJerksApplyToJointMotionOnly) {
    ReadyShell ready(make(three_slide_machine()), joint_pos({0, 0, 0}));
    const double straight_s = ready.time_to(joint_pos({50, 0, 0}));
    const double jerk = 5000;
    ASSERT_EQ(ready.planner.SetJointJerks({}, std::vector<double>(3, jerk)), Status::RRS_SUCCESS);
    // 100 mm/s is reached in sqrt(100 / 5000) s twice over, below 1000 mm/s2; the mean of a ramp is half.
    const double ramp_s = 2 * std::sqrt(100 / jerk);
    EXPECT_NEAR(ready.time_to(joint_pos({0, 0, 0})), 50.0 / 100 + ramp_s, 1e-9);
    EXPECT_GT(0.5 + ramp_s, straight_s);
    ready.planner.SelectMotionType(MotionType::linear);
    ready.planner.SetCartesianPositionSpeed(kUnlimited);
    EXPECT_NEAR(ready.time_to(joint_pos({50, 0, 0})), straight_s, 1e-12);
    ready.planner.SelectMotionType(MotionType::joint);
    ASSERT_EQ(ready.planner.SetRampMode(RampMode::linear), Status::RRS_SUCCESS);
    EXPECT_NEAR(ready.time_to(joint_pos({0, 0, 0})), straight_s, 1e-12);
    EXPECT_EQ(ready.planner.SetJointJerks({}, std::vector<double>(3, 0.0)), Status::RRS_INVALID_PARAMETER);
}

TEST_P(RampServices, ProgrammedRampModesChangeDuration) {
    PlannerSetup setup = three_slide_machine();
    for (JointSetup& joint : setup.joints) joint.max_jerk = 20000;
    ReadyShell ready(make(setup), joint_pos({0, 0, 0}));
    const double machine_s = ready.time_to(joint_pos({50, 0, 0}));
    EXPECT_NEAR(machine_s, 0.5 + 0.1, 1e-12);
    ready.planner.SetRampMode(RampMode::s_curve);
    EXPECT_NEAR(ready.time_to(joint_pos({0, 0, 0})), 0.5 + 0.1 + 1000.0 / 20000, 1e-12);
    ready.planner.SetRampMode(RampMode::infinite);
    EXPECT_NEAR(ready.time_to(joint_pos({50, 0, 0})), 0.5, 1e-12);
    ready.planner.SetRampMode(RampMode::linear);
    EXPECT_NEAR(ready.time_to(joint_pos({0, 0, 0})), machine_s, 1e-12);
    EXPECT_EQ(ready.planner.SetRampMode(static_cast<RampMode>(9)), Status::RRS_INVALID_PARAMETER);
    ready.planner.SetRampMode(RampMode::infinite);
    ready.planner.Reset();
    ready.planner.SetInitialPosition(rrs::CartPos::Identity(), joint_pos({0, 0, 0}), "");
    EXPECT_EQ(ready.time_to(joint_pos({50, 0, 0})), machine_s) << "a new session has the machine's ramps";
}

TEST_P(RampServices, ProgrammedLimitsCanOnlyLowerMachineLimits) {
    ReadyShell ready(make(three_slide_machine()), joint_pos({0, 0, 0}));
    const int x = 0;
    const double slow = 200;
    const double fast = 1e6;
    ASSERT_EQ(ready.planner.SetJointRampLimits(RampLimit::acceleration, {&x, 1}, {&slow, 1}),
              Status::RRS_SUCCESS);
    EXPECT_NEAR(ready.time_to(joint_pos({100, 0, 0})), 1 + 100.0 / 200 / 2 + 100.0 / 1000 / 2, 1e-12);
    ASSERT_EQ(ready.planner.SetJointRampLimits(RampLimit::deceleration, {&x, 1}, {&slow, 1}),
              Status::RRS_SUCCESS);
    EXPECT_NEAR(ready.time_to(joint_pos({0, 0, 0})), 1 + 100.0 / 200, 1e-12);
    for (const RampLimit limit : {RampLimit::acceleration, RampLimit::deceleration})
        ready.planner.SetJointRampLimits(limit, {&x, 1}, {&fast, 1});
    EXPECT_NEAR(ready.time_to(joint_pos({100, 0, 0})), 1 + 100.0 / 1000, 1e-12) << "the machine's hold";
    const double zero = 0;
    EXPECT_EQ(ready.planner.SetJointRampLimits(RampLimit::jerk, {&x, 1}, {&zero, 1}),
              Status::RRS_INVALID_PARAMETER);
}

}  // namespace
}  // namespace gsim::motion::rest_ramps_test
