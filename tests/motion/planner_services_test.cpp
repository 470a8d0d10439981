#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/motion/planner_under_test.h"

namespace gsim::motion::planner_services_test {
namespace {

using rrs::CartPos;
using rrs::Status;
using testing::HasSubstr;

const rrs::JointPos kStart = joint_pos({500, 500, 300, 0, 0});

class PlannerServices : public AnyPlanner {
  protected:
    PlannerServices() : owner(make(gantry_setup())), planner(*owner) {
        planner.Initialize();
        planner.SetInitialPosition(CartPos::Identity(), kStart, "");
    }
    Status to(const rrs::JointPos& joints) { return enqueue(planner, joints); }

    std::unique_ptr<rrs::Shell> owner;
    rrs::Shell& planner;
};

INSTANTIATE_TEST_SUITE_P(Ways, PlannerServices, all_ways(), way_name);

TEST_P(PlannerServices, ReportUnsupportedServiceByName) {
    CartPos pose = CartPos::Identity();
    const std::vector<std::pair<const char*, Status>> statuses{
        {"GetCellFrame", planner.GetCellFrame("BASE", pose)},
        {"ModifyCellFrame", planner.ModifyCellFrame("TOOL", pose)},
        {"SelectWorkFrames", planner.SelectWorkFrames("TOOL", "BASE")},
        {"SelectTrajectoryMode", planner.SelectTrajectoryMode(1)},
    };
    for (const auto& [name, status] : statuses) EXPECT_EQ(status, Status::RRS_SERVICE_NOT_SUPPORTED) << name;
    EXPECT_THAT(message(planner),
                testing::ContainsRegex("does not (offer|support) the service SelectTrajectoryMode\\."));
}

TEST_P(PlannerServices, RejectCallsBeforeInitializeAndAfterTerminate) {
    const auto fresh = make(gantry_setup());
    const auto status = [&] {
        return fresh->SetNextTarget(1, rrs::TargetParam::end, CartPos::Identity(), kStart, "", 0);
    };
    EXPECT_EQ(status(), Status::RRS_NOT_INITIALIZED);
    EXPECT_EQ(fresh->SetCartesianPositionSpeed(1), Status::RRS_NOT_INITIALIZED);
    EXPECT_EQ(fresh->SetInitialPosition(CartPos::Identity(), kStart, ""), Status::RRS_NOT_INITIALIZED);
    EXPECT_EQ(fresh->Reset(), Status::RRS_NOT_INITIALIZED);
    std::string text;
    EXPECT_EQ(fresh->GetMessage(text), Status::RRS_SUCCESS);
    EXPECT_EQ(text, "The planner is not initialized; call Initialize first.");
    EXPECT_EQ(fresh->Initialize(), Status::RRS_SUCCESS);
    EXPECT_EQ(status(), Status::RRS_NO_INITIAL_POSITION);
    EXPECT_EQ(fresh->SetNextRest(1, 1), Status::RRS_NO_INITIAL_POSITION);
    EXPECT_EQ(fresh->Terminate(), Status::RRS_SUCCESS);
    EXPECT_EQ(status(), Status::RRS_NOT_INITIALIZED);
}

TEST_P(PlannerServices, ResetRestoresInitialState) {
    const rrs::JointPos target = joint_pos({600, 500, 300, 0, 0});
    to(target);
    const double time_s = step_to_end(planner, 0.01).time_s;
    planner.SetOverrideSpeed(10);
    to(kStart);
    EXPECT_EQ(planner.Reset(), Status::RRS_SUCCESS);
    EXPECT_EQ(to(kStart), Status::RRS_NO_INITIAL_POSITION);
    planner.SetInitialPosition(CartPos::Identity(), kStart, "");
    EXPECT_EQ(step_to_end(planner, 0.01).time_s, 0);
    to(target);
    EXPECT_NEAR(step_to_end(planner, 0.01).time_s, time_s, 1e-12);
}

TEST_P(PlannerServices, ReportJointValueAndLimitOfTargetOutOfRange) {
    EXPECT_EQ(to(joint_pos({500, 500, 650, 0, 0})), Status::RRS_JOINT_LIMIT);
    EXPECT_EQ(message(planner),
              "Joint 2 (counted from 0) would be at 650 mm at the target; its range ends at 609.6 mm.");
    EXPECT_EQ(to(joint_pos({500, 500, 300, 0, -2})), Status::RRS_JOINT_LIMIT);
    EXPECT_THAT(message(planner), HasSubstr("would be at -2 rad at the target; its range ends at -1.57"));
    EXPECT_EQ(planner.SetInitialPosition(CartPos::Identity(), joint_pos({-1, 0, 0, 0, 0}), ""),
              Status::RRS_JOINT_LIMIT);
    EXPECT_EQ(step_to_end(planner, 0.01).time_s, 0);
    EXPECT_EQ(position(planner), kStart);
}

// In process alone: the services return the message, not its numbers.
TEST(PlannerErrors, ContainJointValueAndLimit) {
    ReadyPlanner at(gantry_setup(), kStart);
    at.to(joint_pos({500, 500, 650, 0, 0}));
    EXPECT_EQ(at.planner.last_error().joint, 2);
    EXPECT_EQ(at.planner.last_error().value, 650);
    EXPECT_EQ(at.planner.last_error().limit, 609.6);
    EXPECT_EQ(at.planner.position(), kStart);
    EXPECT_EQ(at.planner.time_s(), 0);
}

TEST_P(PlannerServices, AcceptRangeEndWithinRounding) {
    EXPECT_EQ(to(joint_pos({0, 500, 609.6 + 1e-12, 0, kPi / 2})), Status::RRS_SUCCESS);
    EXPECT_EQ(to(joint_pos({-1e-8, 500, 0, 0, 0})), Status::RRS_JOINT_LIMIT);
}

TEST_P(PlannerServices, MessageContainsTargetName) {
    const auto status = planner.SetNextNamedTarget(7, rrs::TargetParam::end, CartPos::Identity(),
                                                   joint_pos({500, 500, 650, 0, 0}), "", 0, "CORNER");
    EXPECT_EQ(status, Status::RRS_JOINT_LIMIT);
    EXPECT_THAT(message(planner), HasSubstr("Target CORNER: Joint 2"));
    planner.SetNextNamedTarget(8, rrs::TargetParam::end, CartPos::Identity(),
                               joint_pos({500, 500, 400, 0, 0}), "", 0, "P");
    step_to_end(planner, 0.01);
    rrs::TargetId reached = 0;
    EXPECT_EQ(planner.GetTargetOfLastStep(reached), Status::RRS_SUCCESS);
    EXPECT_EQ(reached, 8);
}

TEST_P(PlannerServices, RejectValuesOutOfRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1.0, nan, -infinity}) {
        EXPECT_EQ(planner.SetCartesianPositionSpeed(bad), Status::RRS_INVALID_PARAMETER) << bad;
        EXPECT_EQ(planner.SetCartesianOrientationSpeed(bad), Status::RRS_INVALID_PARAMETER) << bad;
        EXPECT_EQ(planner.SetCartesianPositionAcceleration(bad), Status::RRS_INVALID_PARAMETER) << bad;
        EXPECT_EQ(planner.SetCartesianOrientationAcceleration(bad), Status::RRS_INVALID_PARAMETER) << bad;
        EXPECT_EQ(planner.SetOverrideSpeed(bad), Status::RRS_INVALID_PARAMETER) << bad;
        EXPECT_EQ(planner.SetOverrideAcceleration(bad), Status::RRS_INVALID_PARAMETER) << bad;
        EXPECT_EQ(planner.SetMotionTime(bad), Status::RRS_INVALID_PARAMETER) << bad;
        EXPECT_EQ(planner.SetInterpolationTime(bad), Status::RRS_INVALID_PARAMETER) << bad;
        EXPECT_EQ(planner.SetJointSpeeds(std::vector{1}, std::vector{bad}), Status::RRS_INVALID_PARAMETER)
            << bad;
    }
    for (const double bad : {-1.0, nan, infinity}) {
        EXPECT_EQ(planner.SetRestParameter(bad), Status::RRS_INVALID_PARAMETER) << bad;
        EXPECT_EQ(planner.SetNextRest(1, bad), Status::RRS_INVALID_PARAMETER) << bad;
    }
    EXPECT_EQ(planner.SetOverrideSpeed(201), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner.SetMotionTime(infinity), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner.SetInterpolationTime(1e-7), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner.SetCartesianPositionSpeed(infinity), Status::RRS_SUCCESS);
}

TEST_P(PlannerServices, RejectAllJointValuesIfOneIsInvalid) {
    EXPECT_EQ(planner.SetJointSpeeds(std::vector{5}, std::vector{1.0}), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(message(planner), "Joint 5 does not exist; joints are 0 to 4.");
    EXPECT_EQ(planner.SetJointSpeeds(std::vector{-1}, std::vector{1.0}), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner.SetJointSpeeds({}, std::vector{1.0}), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(message(planner), "1 values were given for the speed of 5 joints.");
    // A bad value at the end leaves the good ones before it out, too.
    EXPECT_EQ(planner.SetJointSpeeds(std::vector{0, 1}, std::vector{1.0, -1.0}),
              Status::RRS_INVALID_PARAMETER);
    to(joint_pos({1500, 500, 300, 0, 0}));
    EXPECT_LT(step_to_end(planner, 0.01).time_s, 10);
}

TEST_P(PlannerServices, RejectUnknownSelections) {
    EXPECT_EQ(planner.SelectMotionType(static_cast<rrs::MotionType>(3)), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner.SelectTargetType(static_cast<rrs::TargetType>(9)), Status::RRS_INVALID_PARAMETER);
    for (const int number : {-1, 3}) {
        EXPECT_EQ(planner.SetPathMode(static_cast<rrs::PathMode>(number), 0, 0),
                  Status::RRS_INVALID_PARAMETER);
        EXPECT_EQ(planner.ComeToRest(static_cast<rrs::RestReason>(number)), Status::RRS_INVALID_PARAMETER);
    }
    EXPECT_EQ(planner.SelectDominantInterpolation(static_cast<rrs::Dominance>(-1)),
              Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner.SetNextTarget(1, static_cast<rrs::TargetParam>(5), CartPos::Identity(), kStart, "", 0),
              Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(planner.SelectFlybyMode(false), Status::RRS_SUCCESS);
    EXPECT_EQ(planner.SelectFlybyMode(true), Status::RRS_MODE_NOT_SUPPORTED);
}

TEST_P(PlannerServices, MachineWithoutPositionJointsHasOnlyJointMotion) {
    PlannerSetup setup = gantry_setup();
    setup.position_joints = {-1, -1, -1};
    const auto robot = make(setup);
    robot->Initialize();
    robot->SetInitialPosition(CartPos::Identity(), kStart, "");
    EXPECT_EQ(robot->SelectMotionType(rrs::MotionType::linear), Status::RRS_MOTION_TYPE_NOT_SUPPORTED);
    EXPECT_EQ(robot->SelectMotionType(rrs::MotionType::circular), Status::RRS_MOTION_TYPE_NOT_SUPPORTED);
    EXPECT_EQ(robot->SetNextArcTarget(1, {1, 1, 1}, Eigen::Vector3d::UnitZ(), 1, CartPos::Identity(), kStart),
              Status::RRS_MOTION_TYPE_NOT_SUPPORTED);
    const rrs::JointPos target = joint_pos({600, 500, 300, 0.1, 0});
    EXPECT_EQ(enqueue(*robot, target), Status::RRS_SUCCESS);
    EXPECT_EQ(step_to_end(*robot, 0.01).joints, target);
}

// In process alone: steps have no length.
TEST(PlannerMotionTypes, JointMotionWithoutPositionJointsHasNoLength) {
    PlannerSetup setup = gantry_setup();
    setup.position_joints = {-1, -1, -1};
    ReadyPlanner robot(setup, kStart);
    robot.to(joint_pos({600, 500, 300, 0.1, 0}));
    EXPECT_EQ(robot.last().length_mm, 0);
}

}  // namespace
}  // namespace gsim::motion::planner_services_test
