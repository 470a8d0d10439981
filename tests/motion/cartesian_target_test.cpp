#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/kinematics/pose.h"
#include "tests/motion/planner_under_test.h"

namespace gsim::motion::cartesian_target_test {
namespace {

using Eigen::Vector3d;
using kinematics::pose_from_rpy;
using rrs::CartPos;
using rrs::Status;

// A gantry in a corner of the cell: its base is turned and moved, and two of its slides run backwards, so
// that the space of its joints is a mirror image of the world.
PlannerSetup turned_setup(const CartPos& base) {
    PlannerSetup setup = gantry_setup();
    std::vector<kinematics::DhLink> rows = kinematics::gantry_rows();
    setup.kinematics = kinematics::GantryKinematics::make(
                           kinematics::DhChain(base * kinematics::gantry_base(), rows, CartPos::Identity()))
                           .value();
    std::swap(setup.position_joints[0], setup.position_joints[1]);  // x and y of the axis space are swapped
    for (JointSetup& joint : setup.joints) joint.min = -5000;
    return setup;
}

class CartesianTarget : public AnyPlanner {
  protected:
    CartesianTarget() : owner(make(turned_setup(base))), planner(*owner) {
        planner.Initialize();
        planner.SelectTargetType(rrs::TargetType::cartesian);
        planner.SelectMotionType(rrs::MotionType::linear);
        planner.SetCartesianPositionSpeed(100);
        EXPECT_EQ(planner.SetInitialPosition(start, rrs::JointPos(), ""), Status::RRS_SUCCESS);
    }
    Status to(const CartPos& pose, rrs::TargetParam param = rrs::TargetParam::end) {
        return planner.SetNextTarget(1, param, pose, rrs::JointPos(), "", 0);
    }
    /// Runs the targets that `queue` enqueues twice, so that a step of half their time meets the middle.
    template <typename Queue>
    void move(const Queue& queue) {
        ASSERT_EQ(queue(), Status::RRS_SUCCESS) << message(planner);
        full = step_to_end(planner, 1e-4);
        ASSERT_EQ(planner.SetInitialPosition(start, rrs::JointPos(), ""), Status::RRS_SUCCESS);
        ASSERT_EQ(queue(), Status::RRS_SUCCESS);
        planner.SetInterpolationTime(full.time_s / 2);
        rrs::JointPos joints;
        double elapsed_s = 0;
        planner.GetNextStep(joints, middle, elapsed_s);
    }

    const CartPos base =
        pose_from_rpy({.x_mm = 300, .y_mm = -40, .z_mm = 10, .roll_rad = 0.7, .pitch_rad = 0.2});
    const CartPos start = base * pose_from_rpy({.x_mm = 500, .y_mm = 500, .z_mm = 300});
    std::unique_ptr<rrs::Shell> owner;
    rrs::Shell& planner;
    Stepped full;
    CartPos middle;
};

INSTANTIATE_TEST_SUITE_P(Ways, CartesianTarget, all_ways(), way_name);

TEST_P(CartesianTarget, MovesAlongLineInWorldFrame) {
    CartPos end = start;
    end.translation() += Vector3d(100, 200, -50);
    move([&] { return to(end); });
    EXPECT_TRUE(full.pose.isApprox(end, 1e-12));
    EXPECT_LT((middle.translation() - (start.translation() + Vector3d(50, 100, -25))).norm(), 1e-6);
    EXPECT_NEAR(full.distance_mm, Vector3d(100, 200, -50).norm(), 1e-5);
}

TEST_P(CartesianTarget, ArcByCenterKeepsDirectionInWorldFrame) {
    const Vector3d center = start.translation() - Vector3d(100, 0, 0);
    CartPos end = start;
    end.translation() = center + Vector3d(0, 100, 0);
    move([&] {
        return planner.SetNextArcTarget(1, center, Vector3d::UnitZ(), kPi / 2, end, rrs::JointPos());
    });
    EXPECT_LT((middle.translation() - (center + std::sqrt(5000) * Vector3d(1, 1, 0))).norm(), 1e-6);
    EXPECT_NEAR(full.distance_mm, 50 * kPi, 1e-5);
}

TEST_P(CartesianTarget, ArcPassesViaPointInWorldFrame) {
    planner.SelectMotionType(rrs::MotionType::circular);
    const Vector3d center = start.translation() - Vector3d(100, 0, 0);
    CartPos via = start, end = start;
    via.translation() = center + Vector3d(0, 0, 100);
    end.translation() = center - Vector3d(100, 0, 0);
    move([&] {
        EXPECT_EQ(to(via, rrs::TargetParam::via), Status::RRS_SUCCESS);
        return to(end);
    });
    EXPECT_LT((middle.translation() - via.translation()).norm(), 1e-6);
}

TEST_P(CartesianTarget, JointMotionReachesPose) {
    planner.SelectMotionType(rrs::MotionType::joint);
    const CartPos end = start * pose_from_rpy({.x_mm = 100, .roll_rad = 0.4, .pitch_rad = 0.3});
    move([&] { return to(end); });
    EXPECT_TRUE(full.pose.isApprox(end, 1e-12));
    EXPECT_NEAR(full.joints[3], 0.4, 1e-9);
    EXPECT_NEAR(full.joints[4], 0.3, 1e-9);
}

TEST_P(CartesianTarget, RejectsScaledRotationMatrix) {
    CartPos bad = start;
    bad.linear() *= 1.1;
    EXPECT_EQ(to(bad), Status::RRS_INVALID_PARAMETER);
    EXPECT_THAT(message(planner), testing::HasSubstr("is not a rotation"));
}

TEST_P(CartesianTarget, RejectsPoseWithoutInverseKinematics) {
    std::mt19937 random(1);
    const auto forward_only = make(odd_setup(random));
    forward_only->Initialize();
    forward_only->SelectTargetType(rrs::TargetType::cartesian);
    EXPECT_EQ(forward_only->SetInitialPosition(start, rrs::JointPos(), ""), Status::RRS_NO_SOLUTION);
    EXPECT_THAT(message(*forward_only), testing::HasSubstr("no inverse kinematics"));
}

TEST_P(CartesianTarget, InverseKinematicsInvertsForwardKinematics) {
    const rrs::JointPos joints = joint_pos({100, 200, 300, 0.4, 0.5});
    CartPos pose;
    rrs::JointPos back;
    ASSERT_EQ(planner.GetForwardKinematics(joints, pose), Status::RRS_SUCCESS);
    ASSERT_EQ(planner.GetInverseKinematics(pose, joints, back), Status::RRS_SUCCESS);
    EXPECT_LT((back - joints).norm(), 1e-9);
    EXPECT_EQ(planner.GetForwardKinematics(joint_pos({1}), pose), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner.GetInverseKinematics(pose, joint_pos({1}), back), Status::RRS_INVALID_PARAMETER);
}

}  // namespace
}  // namespace gsim::motion::cartesian_target_test
