// StopMotion, ContinueMotion and CancelMotion, at any instant and within limits.

#include "tests/motion/motion_checks.h"
#include "tests/motion/planner_under_test.h"

namespace gsim::motion::stop_test {
namespace {

using rrs::MotionType;
using rrs::Status;

rrs::JointPos random_target(std::mt19937& random, int joints) {
    std::uniform_real_distribution<double> place(-60, 60);
    rrs::JointPos target(joints);
    for (double& value : target) value = place(random);
    return target;
}

PlannerSetup look_ahead_setup() {
    PlannerSetup setup = three_slide_machine();
    setup.controller.planner = rrs::PlannerKind::look_ahead;
    setup.controller.corners.continuous = rrs::CornerRule::velocity_step;
    setup.queue_capacity = 400;
    return setup;
}

Step step(DefaultPlanner& planner) {
    Step step{};
    rrs::CartPos pose;
    step.status = planner.GetNextStep(step.joints, pose, step.elapsed_s);
    return step;
}

/// Takes steps until the robot is at standstill; returns the number of targets that it reached.
int run_out(DefaultPlanner& planner, rrs::JointPos& at) {
    int reached = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const Step now = step(planner);
        at = now.joints;
        if (now.status == Status::RRS_NEED_MORE_DATA) return reached;
        if (now.status == Status::RRS_TARGET_REACHED) ++reached;
    }
    ADD_FAILURE() << "it does not come to an end";
    return reached;
}

class StopServices : public AnyPlanner {};
INSTANTIATE_TEST_SUITE_P(Ways, StopServices, all_ways(), way_name);

TEST_P(StopServices, TrapezoidStopsWithinBrakingDistance) {
    ReadyShell ready(make(three_slide_machine()), joint_pos({0, 0, 0}));
    ready.planner.SetInterpolationTime(0.5);
    ready.to(joint_pos({100, 0, 0}));
    EXPECT_NEAR(ready.step().joints[0], 45, 1e-9);
    ASSERT_EQ(ready.planner.StopMotion(), Status::RRS_SUCCESS);
    EXPECT_EQ(ready.to(joint_pos({0, 0, 0})), Status::RRS_QUEUE_FULL);
    const Step stopped = ready.step();
    EXPECT_NEAR(stopped.joints[0], 50, 1e-9) << "100^2 / 2 / 1000";
    EXPECT_NEAR(stopped.elapsed_s, 0.1, 1e-9);
    EXPECT_EQ(ready.step().status, Status::RRS_NEED_MORE_DATA);
    ASSERT_EQ(ready.planner.ContinueMotion(), Status::RRS_SUCCESS);
    rrs::JointPos at;
    EXPECT_EQ(ready.run_out(at), 1);
    EXPECT_EQ(at, joint_pos({100, 0, 0}));
    EXPECT_NEAR(ready.time_s, 0.6 + trapezoid_s(50, 100, 1000), 1e-9);
}

TEST_P(StopServices, CancelDropsRemainingMotion) {
    ReadyShell ready(make(three_slide_machine()), joint_pos({0, 0, 0}));
    ready.planner.SetInterpolationTime(0.5);
    ready.to(joint_pos({100, 0, 0}));
    ready.to(joint_pos({100, 100, 0}));
    ready.step();
    EXPECT_EQ(ready.planner.CancelMotion(), Status::RRS_INVALID_PARAMETER);
    ready.planner.StopMotion();
    ASSERT_EQ(ready.planner.CancelMotion(), Status::RRS_SUCCESS);
    EXPECT_NEAR(position(ready.planner)[0], 50, 1e-9);
    ASSERT_EQ(ready.to(joint_pos({0, 0, 0})), Status::RRS_SUCCESS);
    rrs::JointPos at;
    EXPECT_EQ(ready.run_out(at), 1);
    EXPECT_EQ(at, joint_pos({0, 0, 0}));
}

TEST_P(StopServices, StopAndContinueWorkAtStandstill) {
    ReadyShell ready(make(three_slide_machine()), joint_pos({0, 0, 0}));
    EXPECT_EQ(ready.planner.ContinueMotion(), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(ready.planner.StopMotion(), Status::RRS_SUCCESS);
    EXPECT_EQ(ready.planner.StopMotion(), Status::RRS_SUCCESS);
    EXPECT_EQ(ready.planner.ContinueMotion(), Status::RRS_SUCCESS);
    ready.planner.SetNextRest(7, 2);
    ready.planner.SetInterpolationTime(0.5);
    ready.step();
    ready.planner.StopMotion();
    EXPECT_EQ(ready.step().status, Status::RRS_NEED_MORE_DATA);
    ready.planner.ContinueMotion();
    rrs::JointPos at;
    ready.run_out(at);
    EXPECT_NEAR(ready.time_s, 2, 1e-12) << "a dwell goes on";
}

/// Straight ahead over short blocks, straight ramps brake as over one.
TEST_P(StopServices, ShortBlocksDoNotDelayStop) {
    ReadyShell ready(make(look_ahead_setup()), joint_pos({0, 0, 0}));
    ready.planner.SelectFlybyMode(true);
    ready.planner.SelectMotionType(MotionType::linear);
    ready.planner.SetCartesianPositionSpeed(100);
    for (int i = 1; i <= 300; ++i) ready.to(joint_pos({0.5 * i, 0, 0}));
    ready.planner.SetInterpolationTime(0.5);
    EXPECT_NEAR(ready.step().joints[0], 45, 1e-6);
    ready.planner.StopMotion();
    EXPECT_NEAR(ready.step().joints[0], 50, 1e-6);
    EXPECT_EQ(ready.step().status, Status::RRS_NEED_MORE_DATA);
}

TEST_P(StopServices, StopStaysOnArc) {
    for (const auto kind : {rrs::PlannerKind::rest_to_rest, rrs::PlannerKind::look_ahead}) {
        PlannerSetup setup = three_slide_machine();
        setup.controller.planner = kind;
        ReadyShell ready(make(setup), joint_pos({50, 0, 0}));
        ready.planner.SetCartesianPositionSpeed(80);
        ASSERT_EQ(ready.arc_to(joint_pos({50, 0, 10}), {0, 0, 0}, {0, 0, 1}, 2 * kPi), Status::RRS_SUCCESS)
            << message(ready.planner);
        ready.planner.SetInterpolationTime(0.7);
        ready.step();
        ready.step();
        ready.planner.StopMotion();
        rrs::JointPos at;
        ready.run_out(at);
        EXPECT_NEAR(std::hypot(at[0], at[1]), 50, 1e-9);
        ready.planner.ContinueMotion();
        EXPECT_EQ(ready.run_out(at), 1);
        EXPECT_LT((at - joint_pos({50, 0, 10})).norm(), 1e-9);
    }
}

/// Stops one of many random motions at a random instant, continues it, and stops it again.
void stop_and_go(std::mt19937& random, const PlannerSetup& setup, bool joint_motion) {
    const int joints = setup.joint_count();
    ReadyPlanner ready(setup, rrs::JointPos::Zero(joints));
    DefaultPlanner& planner = ready.planner;
    planner.SetCartesianPositionSpeed(90);
    planner.SelectFlybyMode(true);
    planner.SelectMotionType(joint_motion ? MotionType::joint : MotionType::linear);
    planner.SetInterpolationTime(0.003);
    rrs::JointPos target = rrs::JointPos::Zero(joints);
    std::uniform_real_distribution<double> nudge(-1, 4);
    const bool short_blocks = std::bernoulli_distribution(0.5)(random);
    const int count = short_blocks ? 60 : 4;
    for (int i = 0; i < count; ++i) {
        if (short_blocks) {
            for (double& value : target) value += nudge(random);
        } else {
            target = random_target(random, joints);
        }
        ASSERT_EQ(ready.to(target), Status::RRS_SUCCESS) << ready.message();
    }
    planner.SetInterpolationTime(std::max(planner.time_s() / 300, 0.003));
    for (int stops = 0; stops < 3; ++stops) {
        const int steps = std::uniform_int_distribution<int>(0, 200)(random);
        for (int i = 0; i < steps; ++i) step(planner);
        ASSERT_EQ(planner.StopMotion(), Status::RRS_SUCCESS);
        rrs::JointPos at;
        run_out(planner, at);
        ASSERT_EQ(planner.ContinueMotion(), Status::RRS_SUCCESS);
    }
    rrs::JointPos at;
    run_out(planner, at);
    ASSERT_EQ(at, target);
    expect_joined(ready.collector.segments);
    for (const Segment& segment : ready.collector.segments) {
        expect_segment_limits(segment, setup);
        if (testing::Test::HasFatalFailure()) return;
    }
    double stands = 0;
    for (const Segment& segment : ready.collector.segments) stands += segment.master.end_speed() == 0;
    EXPECT_GE(stands, 1);
}

TEST(Stop, KeepsLimitsWithFollowersAndJerks) {
    std::mt19937 random(21);
    for (int round = 0; round < 120; ++round) {
        PlannerSetup setup = odd_setup(random);
        set_ramps(setup, random, round % 2 == 0);
        setup.controller.coordination.independent_ramps = round % 4 < 3;
        stop_and_go(random, setup, round % 3 == 0);
        if (testing::Test::HasFatalFailure()) FAIL() << "round " << round;
    }
}

TEST(Stop, KeepsLimitsOverManyBlocks) {
    std::mt19937 random(22);
    for (int round = 0; round < 120; ++round) {
        PlannerSetup setup = look_ahead_setup();
        set_ramps(setup, random, round % 2 == 0);
        stop_and_go(random, setup, false);
        if (testing::Test::HasFatalFailure()) FAIL() << "round " << round;
    }
}

TEST(Stop, KeepsFullLengthOfArc) {
    for (const auto kind : {rrs::PlannerKind::rest_to_rest, rrs::PlannerKind::look_ahead}) {
        PlannerSetup setup = three_slide_machine();
        setup.controller.planner = kind;
        ReadyPlanner ready(setup, joint_pos({50, 0, 0}));
        ready.planner.SetCartesianPositionSpeed(80);
        ready.arc_to(joint_pos({50, 0, 10}), {0, 0, 0}, {0, 0, 1}, 2 * kPi);
        ready.planner.SetInterpolationTime(0.7);
        step(ready.planner);
        ready.planner.StopMotion();
        ready.planner.flush();
        expect_joined(ready.collector.segments);
        double length_mm = 0;
        for (const Segment& segment : ready.collector.segments) length_mm += segment.length_mm;
        EXPECT_NEAR(length_mm, std::hypot(2 * kPi * 50, 10), 1e-6);
    }
}

/// A rotary joint that takes longer to stop than the tool continues independently, and the tool stays on its
/// arc.
TEST(Stop, RotaryJointStopsIndependentlyOfArc) {
    std::mt19937 random(23);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int run = 0; run < 150; ++run) {
        PlannerSetup setup = gantry_setup();
        setup.controller.coordination.independent_ramps = true;
        for (JointSetup& joint : setup.joints) {
            joint.min = -kUnlimited;
            joint.max = kUnlimited;
            joint.max_acceleration *= std::exp(2 * unit(random) - 1);
        }
        set_ramps(setup, random, run % 2 == 0);
        ReadyPlanner ready(setup, rrs::JointPos::Zero(5));
        ready.planner.SetCartesianPositionSpeed(20 + 200 * unit(random));
        rrs::JointPos at = rrs::JointPos::Zero(5);
        for (int i = 0; i < 3; ++i) {
            const double radius = 5 + 50 * unit(random), sweep = 0.3 + 4 * unit(random);
            const Eigen::Vector3d center = at.head<3>() + Eigen::Vector3d(0, radius, 0);
            at.head<2>() = center.head<2>() + radius * Eigen::Vector2d(std::sin(sweep), -std::cos(sweep));
            at[3] += 0.5 * unit(random);
            ASSERT_EQ(ready.arc_to(at, center, Eigen::Vector3d::UnitZ(), sweep), Status::RRS_SUCCESS)
                << ready.message();
        }
        for (int stops = 0; stops < 3; ++stops) {
            ready.planner.SetInterpolationTime(ready.planner.time_s() * unit(random) / 3);
            step(ready.planner);
            ASSERT_EQ(ready.planner.StopMotion(), Status::RRS_SUCCESS);
            ready.planner.ContinueMotion();
        }
        ready.planner.flush();
        ASSERT_NO_FATAL_FAILURE(expect_joined(ready.collector.segments)) << "run " << run;
        for (const Segment& segment : ready.collector.segments) {
            for (int i = 0; i <= 8; ++i) {  // it moves at the reported speed, and not back
                const JointState state = segment.at(segment.duration_s * i / 8);
                const double speed = segment.master.at(segment.duration_s * i / 8).v;
                ASSERT_NEAR(state.velocity.head<3>().norm(), speed, 1e-6 * (1 + speed)) << "run " << run;
                ASSERT_LT((state.position - segment.start).head<3>().norm(), segment.length_mm + 1e-6);
            }
        }
        ASSERT_LT((ready.collector.segments.back().end_position() - at).norm(), 1e-9);
    }
}

}  // namespace
}  // namespace gsim::motion::stop_test
