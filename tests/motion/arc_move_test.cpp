#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/motion/machines.h"
#include "tests/motion/segment_checks.h"

namespace gsim::motion::arc_move_test {
namespace {

using Eigen::Vector3d;
using rrs::Status;
using testing::HasSubstr;

class ArcMove : public testing::Test {
  protected:
    ArcMove() : at(gantry_setup(), joint_pos({600, 500, 300, 0, 0})) {
        at.planner.SelectMotionType(rrs::MotionType::circular);
        at.planner.SetCartesianPositionSpeed(100);
    }
    ReadyPlanner at;
    const Vector3d up = Vector3d::UnitZ();
    const double acceleration = 490.33;
};

TEST_F(ArcMove, FullCircleTakesTimeOfCircumference) {
    ASSERT_EQ(at.arc_to(joint_pos({600, 500, 300, 0, 0}), {500, 500, 0}, up, 2 * kPi), Status::RRS_SUCCESS);
    const Segment& segment = at.last();
    EXPECT_EQ(segment.kind, SegmentKind::circular);
    EXPECT_DOUBLE_EQ(segment.length_mm, 200 * kPi);
    EXPECT_DOUBLE_EQ(segment.duration_s, 2 * kPi + 100 / acceleration);
    EXPECT_LT((segment.position_at(segment.duration_s / 2) - joint_pos({400, 500, 300, 0, 0})).norm(), 1e-9);
    EXPECT_GT(segment.position_at(segment.duration_s / 4)[1], 500);  // counter-clockwise
    EXPECT_DOUBLE_EQ(segment.peak_centripetal_mm_s2(), 100 * 100 / 100.0);
    expect_smooth(segment);
}

TEST_F(ArcMove, ViaPointDefinesCircleAndDirection) {
    ASSERT_EQ(at.via(joint_pos({500, 400, 300, 0, 0})), Status::RRS_SUCCESS);
    ASSERT_EQ(at.to(joint_pos({500, 600, 300, 0, 0})), Status::RRS_SUCCESS);
    const Segment& segment = at.last();
    EXPECT_EQ(segment.target_id, 2);
    EXPECT_NEAR(segment.arc.sweep_rad, 1.5 * kPi, 1e-9);
    EXPECT_LT((segment.position_at(segment.duration_s / 2) -
               joint_pos({500 - std::sqrt(5000), 500 - std::sqrt(5000), 300, 0, 0}))
                  .norm(),
              1e-6);
    expect_smooth(segment);
}

TEST_F(ArcMove, RejectsCircleWithoutViaPoint) {
    EXPECT_EQ(at.to(joint_pos({500, 600, 300, 0, 0})), Status::RRS_INVALID_PARAMETER);
    EXPECT_THAT(at.message(), HasSubstr("needs a via point"));
    at.via(joint_pos({500, 400, 300, 0, 0}));
    at.planner.SelectMotionType(rrs::MotionType::circular);  // drops it
    EXPECT_EQ(at.to(joint_pos({500, 600, 300, 0, 0})), Status::RRS_INVALID_PARAMETER);
    at.planner.SelectMotionType(rrs::MotionType::linear);
    EXPECT_EQ(at.via(joint_pos({500, 400, 300, 0, 0})), Status::RRS_INVALID_PARAMETER);
}

TEST_F(ArcMove, RejectsViaPointOnChord) {
    at.via(joint_pos({550, 500, 300, 0, 0}));
    EXPECT_EQ(at.to(joint_pos({500, 500, 300, 0, 0})), Status::RRS_CIRCLE_IMPOSSIBLE);
    EXPECT_EQ(at.planner.time_s(), 0);
    at.via(joint_pos({550, 450, 300, 0, 0}));
    EXPECT_EQ(at.to(joint_pos({500, 500, 300, 0, 0})), Status::RRS_SUCCESS);
}

TEST_F(ArcMove, ReportsJointValueAndLimitIfArcLeavesRange) {
    EXPECT_EQ(at.arc_to(joint_pos({600, 500, 300, 0, 0}), {600, 1600, 0}, up, 2 * kPi),
              Status::RRS_JOINT_LIMIT);
    EXPECT_EQ(at.planner.last_error().joint, 0);
    EXPECT_NEAR(at.planner.last_error().value, -500, 1e-9);
    EXPECT_EQ(at.planner.last_error().limit, 0);
    EXPECT_THAT(at.message(), HasSubstr("Joint 0 (counted from 0) would be at -500"));
    EXPECT_THAT(at.message(), HasSubstr("mm along the arc; its range ends at 0 mm."));
    EXPECT_EQ(at.planner.time_s(), 0);
    // The near half of the same circle is free.
    EXPECT_EQ(at.arc_to(joint_pos({600 + 1100 * std::sin(0.3), 1600 - 1100 * std::cos(0.3), 300, 0, 0}),
                        {600, 1600, 0}, up, 0.3),
              Status::RRS_SUCCESS)
        << at.message();
}

TEST_F(ArcMove, EndsExactlyAtTargetIfRadiiDiffer) {
    const rrs::JointPos end = joint_pos({500, 600.01, 300, 0.3, 0});
    ASSERT_EQ(at.arc_to(end, {500, 500, 0}, up, kPi / 2), Status::RRS_SUCCESS);
    const Segment& segment = at.last();
    EXPECT_EQ(segment.position_at(segment.duration_s), end);
    expect_smooth(segment);
    const rrs::JointPos before = segment.position_at(segment.duration_s * (1 - 1e-9));
    EXPECT_LT((before - end).norm(), 1e-6);
}

TEST_F(ArcMove, KeepsProgrammedSpeedAlongHelix) {
    ASSERT_EQ(at.arc_to(joint_pos({600, 500, 500, 0, 0}), {500, 500, 0}, up, 4 * kPi), Status::RRS_SUCCESS);
    const double length = std::hypot(400 * kPi, 200);
    EXPECT_DOUBLE_EQ(at.last().length_mm, length);
    EXPECT_DOUBLE_EQ(at.last().duration_s, length / 100 + 100 / acceleration);
    expect_smooth(at.last());
}

TEST_F(ArcMove, SlowerRotaryJointSetsDuration) {
    ASSERT_EQ(at.arc_to(joint_pos({600, 500, 300, 6, 0}), {590, 500, 0}, up, 2 * kPi), Status::RRS_SUCCESS);
    EXPECT_DOUBLE_EQ(at.last().duration_s, trapezoid_s(6, kPi / 2, kPi / 2));
    expect_smooth(at.last());
}

TEST_F(ArcMove, RejectsRapid) {
    at.planner.SetRapid(true);
    EXPECT_EQ(at.arc_to(joint_pos({600, 500, 300, 0, 0}), {500, 500, 0}, up, 2 * kPi),
              Status::RRS_MODE_NOT_SUPPORTED);
}

TEST_F(ArcMove, NeedsProgrammedSpeedOrMotionTime) {
    ReadyPlanner fresh(gantry_setup(), joint_pos({600, 500, 300, 0, 0}));
    EXPECT_EQ(fresh.arc_to(joint_pos({600, 500, 300, 0, 0}), {500, 500, 0}, up, 2 * kPi),
              Status::RRS_ZERO_SPEED);
    fresh.planner.SetMotionTime(10);
    EXPECT_EQ(fresh.arc_to(joint_pos({600, 500, 300, 0, 0}), {500, 500, 0}, up, 2 * kPi),
              Status::RRS_SUCCESS);
    EXPECT_EQ(fresh.last().duration_s, 10);
}

TEST_F(ArcMove, RejectsDirectionWithoutJoint) {
    PlannerSetup setup = gantry_setup();
    setup.position_joints = {0, -1, 2};
    ReadyPlanner lathe(setup, joint_pos({600, 0, 300, 0, 0}));
    lathe.planner.SetCartesianPositionSpeed(100);
    EXPECT_EQ(lathe.arc_to(joint_pos({500, 0, 400, 0, 0}), {500, 0, 300}, Vector3d(0, -1, 0), kPi / 2),
              Status::RRS_SUCCESS)
        << lathe.message();
    EXPECT_EQ(lathe.arc_to(joint_pos({500, 0, 400, 0, 0}), {400, 0, 400}, up, 2 * kPi),
              Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(lathe.message(), "The arc needs a direction in which the machine has no joint.");
}

}  // namespace
}  // namespace gsim::motion::arc_move_test
