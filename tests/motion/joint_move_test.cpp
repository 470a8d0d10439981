#include <vector>

#include <gtest/gtest.h>

#include "tests/motion/machines.h"
#include "tests/motion/segment_checks.h"

namespace gsim::motion::joint_move_test {
namespace {

using rrs::Status;

class JointMove : public testing::Test {
  protected:
    JointMove() : at(gantry_setup(), joint_pos({500, 500, 300, 0, 0})) {}
    const Segment& go(std::initializer_list<double> target) {
        EXPECT_EQ(at.to(joint_pos(target)), Status::RRS_SUCCESS) << at.message();
        return at.last();
    }
    ReadyPlanner at;
};

TEST_F(JointMove, SlowestJointRunsAtLimitsOthersInProportion) {
    const Segment& segment = go({600, 520, 300, kPi, 0.5});
    EXPECT_EQ(segment.kind, SegmentKind::joint);
    EXPECT_DOUBLE_EQ(segment.duration_s, trapezoid_s(kPi, kPi / 2, kPi / 2));
    for (int i = 0; i <= 10; ++i) {
        const JointState state = segment.at(segment.duration_s * i / 10);
        const double share = state.position[3] / kPi;
        EXPECT_NEAR(state.position[0], 500 + 100 * share, 1e-9);
        EXPECT_NEAR(state.position[1], 500 + 20 * share, 1e-9);
        EXPECT_NEAR(state.position[4], 0.5 * share, 1e-12);
    }
    EXPECT_DOUBLE_EQ(segment.at(segment.duration_s / 2).velocity[3], kPi / 2);
    EXPECT_DOUBLE_EQ(segment.length_mm, std::hypot(100, 20));
}

TEST_F(JointMove, KeepsProgrammedJointSpeedButNeedsNone) {
    const std::vector<int> joint{0};
    const std::vector<double> slow{50}, gentle{25};
    at.planner.SetJointSpeeds(joint, slow);
    at.planner.SetJointAccelerations(joint, gentle);
    EXPECT_DOUBLE_EQ(go({700, 500, 300, 0, 0}).duration_s, 200 / 50.0 + 50 / 25.0);
    EXPECT_DOUBLE_EQ(go({700, 600, 300, 0, 0}).duration_s, trapezoid_s(100, 508, 490.33));
    at.planner.SetOverrideSpeed(50);
    EXPECT_DOUBLE_EQ(go({500, 600, 300, 0, 0}).duration_s, 200 / 25.0 + 25 / 25.0);
}

TEST_F(JointMove, ProgrammedValuesNeverExceedLimits) {
    at.planner.SetJointSpeeds({}, std::vector<double>(5, 1e6));
    at.planner.SetJointAccelerations({}, std::vector<double>(5, 1e6));
    EXPECT_DOUBLE_EQ(go({1500, 500, 300, 0, 0}).duration_s, trapezoid_s(1000, 508, 490.33));
}

TEST_F(JointMove, TakesProgrammedMotionTime) {
    at.planner.SetMotionTime(30);
    EXPECT_EQ(go({600, 520, 300, kPi, 0.5}).duration_s, 30);
    expect_smooth(at.last());
}

TEST_F(JointMove, ZeroDistanceGivesSegmentWithoutDuration) {
    EXPECT_EQ(go({500, 500, 300, 0, 0}).duration_s, 0);
    EXPECT_EQ(at.last().kind, SegmentKind::joint);
}

TEST_F(JointMove, RejectsUnlimitedMoveWithoutMotionTime) {
    PlannerSetup setup = gantry_setup();
    for (JointSetup& joint : setup.joints) joint.max_speed = joint.max_acceleration = kUnlimited;
    ReadyPlanner planner(setup, joint_pos({0, 0, 0, 0, 0}));
    EXPECT_EQ(planner.to(joint_pos({1, 0, 0, 0, 0})), Status::RRS_ZERO_SPEED);
    planner.planner.SetMotionTime(2);
    EXPECT_EQ(planner.to(joint_pos({1, 0, 0, 0, 0})), Status::RRS_SUCCESS);
    EXPECT_EQ(planner.last().duration_s, 2);
}

}  // namespace
}  // namespace gsim::motion::joint_move_test
