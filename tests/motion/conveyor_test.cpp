// Motion in the frame of a conveyor, against its closed form; motion of an object.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/motion/machines.h"

namespace gsim::motion::conveyor_test {
namespace {

using rrs::Status;

constexpr double kBelt_mm_s = 100;
constexpr double kAcceleration_mm_s2 = 490.33;
constexpr int kConveyor = 7;

class ConveyorTracking : public testing::Test {
  protected:
    ConveyorTracking() : planner(gantry_setup(), &collector) {
        planner.Initialize();
        planner.SetInitialPosition(rrs::CartPos::Identity(), joint_pos({100, 200, 50, 0, 0}), "");
        planner.SelectMotionType(rrs::MotionType::linear);
        planner.SetCartesianPositionSpeed(150);
    }
    Status go_to(const rrs::JointPos& joints) {
        return planner.SetNextTarget(next_++, rrs::TargetParam::end, rrs::CartPos::Identity(), joints, "", 0);
    }
    /// The world's X is the gantry's first joint.
    void start_belt() {
        ASSERT_EQ(planner.DefineConveyor(kConveyor, Eigen::Vector3d(2, 0, 0), kBelt_mm_s),
                  Status::RRS_SUCCESS);
        ASSERT_EQ(planner.SetConveyorPosition(kConveyor, 30), Status::RRS_SUCCESS);
        ASSERT_EQ(planner.SelectTracking(kConveyor, true), Status::RRS_SUCCESS)
            << planner.last_error().message;
    }
    /// Joint values at an instant.
    rrs::JointPos at(double t_s) const {
        for (const Segment& segment : collector.segments) {
            if (t_s <= segment.end_s()) return segment.position_at(t_s - segment.start_s);
        }
        return collector.segments.back().end_position();
    }

    Collector collector;
    DefaultPlanner planner;
    rrs::TargetId next_ = 1;
};

TEST_F(ConveyorTracking, AcceleratesFollowsAndDecelerates) {
    start_belt();
    const double ramp_s = kBelt_mm_s / kAcceleration_mm_s2;
    EXPECT_NEAR(planner.time_s(), ramp_s, 1e-12);
    // The frame of the belt was at 30 mm: the belt has moved on, and the robot has lagged.
    const double on_belt = 100 + kBelt_mm_s * ramp_s / 2 - (30 + kBelt_mm_s * ramp_s);
    EXPECT_NEAR(planner.position()[0], on_belt, 1e-9);
    ASSERT_EQ(go_to(joint_pos({on_belt + 60, 280, 50, 0, 0})), Status::RRS_SUCCESS);
    const double end_s = planner.time_s();
    const double way_s = 100 / 150.0 + 150 / kAcceleration_mm_s2;  // 100 mm between standstills on the belt
    EXPECT_NEAR(end_s - ramp_s, way_s, 1e-9);
    ASSERT_EQ(planner.SelectTracking(kConveyor, false), Status::RRS_SUCCESS);
    EXPECT_NEAR(planner.time_s(), end_s + ramp_s, 1e-9);
    EXPECT_NEAR(planner.position()[0], on_belt + 60 + 30 + kBelt_mm_s * end_s + kBelt_mm_s * ramp_s / 2,
                1e-9);
    planner.flush();
    EXPECT_NEAR(at(end_s)[0], on_belt + 60 + 30 + kBelt_mm_s * end_s, 1e-9);
    EXPECT_NEAR(at(end_s)[1], 280, 1e-9);
    const double half_s = ramp_s + way_s / 2;  // half of the path on the belt
    EXPECT_NEAR(at(half_s)[0], on_belt + 30 + 30 + kBelt_mm_s * half_s, 1e-9);
    EXPECT_NEAR(at(half_s)[1], 240, 1e-9);
}

TEST_F(ConveyorTracking, KeepsPositionAndSpeedContinuousWithinLimits) {
    start_belt();
    const double x = planner.position()[0];
    planner.SetRapid(true);
    ASSERT_EQ(go_to(joint_pos({x + 300, 500, 50, 0.5, 0})), Status::RRS_SUCCESS);
    ASSERT_EQ(planner.SetNextRest(90, 0.5), Status::RRS_SUCCESS);
    planner.SetRapid(false);
    ASSERT_EQ(planner.SetNextArcTarget(91, {x + 300, 450, 0}, Eigen::Vector3d::UnitZ(), 2 * kPi,
                                       rrs::CartPos::Identity(), joint_pos({x + 300, 500, 50, 0.5, 0})),
              Status::RRS_SUCCESS)
        << planner.last_error().message;
    ASSERT_EQ(planner.SelectTracking(kConveyor, false), Status::RRS_SUCCESS);
    planner.flush();
    rrs::JointPos position = joint_pos({100, 200, 50, 0, 0});
    rrs::JointPos velocity = rrs::JointPos::Zero(5);
    for (const Segment& segment : collector.segments) {
        EXPECT_LT((segment.at(0).position - position).norm(), 1e-9);
        EXPECT_LT((segment.at(0).velocity - velocity).norm(), 1e-6);
        for (int i = 0; i <= 50; ++i) {
            const JointState state = segment.at(segment.duration_s * i / 50);
            for (int joint = 0; joint < 3; ++joint) EXPECT_LE(std::abs(state.velocity[joint]), 508 + 1e-9);
        }
        position = segment.end_position();
        velocity = segment.at(segment.duration_s).velocity;
    }
    EXPECT_LT(velocity.norm(), 1e-6);
}

TEST_F(ConveyorTracking, RejectsInvalidRequests) {
    EXPECT_EQ(planner.SelectTracking(kConveyor, true), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner.SetConveyorPosition(kConveyor, 0), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner.DefineConveyor(kConveyor, Eigen::Vector3d::Zero(), 1), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner.DefineConveyor(kConveyor, Eigen::Vector3d::UnitX(), NAN),
              Status::RRS_INVALID_PARAMETER);
    ASSERT_EQ(planner.DefineConveyor(1, Eigen::Vector3d::UnitX(), 508), Status::RRS_SUCCESS);
    EXPECT_EQ(planner.SelectTracking(1, true), Status::RRS_JOINT_LIMIT);
    start_belt();
    EXPECT_EQ(planner.SelectTracking(1, true), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner.SetConveyorPosition(kConveyor, 0), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner.SetConveyorPosition(kConveyor, 30 + kBelt_mm_s * planner.time_s()),
              Status::RRS_SUCCESS);
    EXPECT_EQ(planner.DefineConveyor(kConveyor, Eigen::Vector3d::UnitX(), 5), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner.StopMotion(), Status::RRS_MODE_NOT_SUPPORTED);
    EXPECT_EQ(go_to(joint_pos({1828, 200, 50, 0, 0})),
              Status::RRS_JOINT_LIMIT);  // the belt carries it out of reach
    EXPECT_EQ(planner.SelectTracking(kConveyor, false), Status::RRS_SUCCESS);
}

rrs::CartPos pose(double x, double turn_rad) {
    rrs::CartPos pose = rrs::CartPos::Identity();
    pose.translate(Eigen::Vector3d(x, 0, 0));
    pose.rotate(Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()));
    return pose;
}

TEST(Object, MovesAtConstantSpeedAndTurnsInProportion) {
    DefaultPlanner planner(gantry_setup());
    rrs::CartPos at;
    double elapsed_s = 0;
    ASSERT_EQ(planner.Initialize(), Status::RRS_SUCCESS);
    EXPECT_EQ(planner.SetObjectNextTarget(1, pose(10, 0)), Status::RRS_ZERO_SPEED);
    EXPECT_EQ(planner.GetNextObjectStep(at, elapsed_s), Status::RRS_NEED_MORE_DATA);
    ASSERT_EQ(planner.SetObjectInitialPosition(pose(100, 0)), Status::RRS_SUCCESS);
    ASSERT_EQ(planner.SetObjectSpeed(50), Status::RRS_SUCCESS);
    ASSERT_EQ(planner.SetObjectNextTarget(1, pose(200, 1.2)), Status::RRS_SUCCESS);  // 2 s
    ASSERT_EQ(planner.SetInterpolationTime(0.5), Status::RRS_SUCCESS);
    for (int i = 1; i <= 3; ++i) {
        EXPECT_EQ(planner.GetNextObjectStep(at, elapsed_s), Status::RRS_SUCCESS);
        EXPECT_DOUBLE_EQ(elapsed_s, 0.5);
        EXPECT_TRUE(at.isApprox(pose(100 + 25 * i, 0.3 * i), 1e-12)) << i;
    }
    ASSERT_EQ(planner.SetInterpolationTime(0.7), Status::RRS_SUCCESS);
    EXPECT_EQ(planner.GetNextObjectStep(at, elapsed_s), Status::RRS_TARGET_REACHED);
    EXPECT_NEAR(elapsed_s, 0.5, 1e-12);
    EXPECT_TRUE(at.isApprox(pose(200, 1.2), 1e-15));
    EXPECT_EQ(planner.SetObjectNextTarget(2, pose(200, 0)), Status::RRS_ZERO_SPEED);  // it would turn only
    EXPECT_EQ(planner.SetObjectSpeed(0), Status::RRS_INVALID_PARAMETER);
}

}  // namespace
}  // namespace gsim::motion::conveyor_test
