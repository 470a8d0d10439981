#include "runtime/rrs/shell.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace gsim::rrs::shell_test {
namespace {

// A controller that offers nothing, but notes what it was asked for.
class BareShell : public Shell {
  public:
    std::string asked;

  protected:
    Status not_supported(std::string_view service) override {
        asked = service;
        return Shell::not_supported(service);
    }
};

using Service = std::pair<const char*, std::function<Status(Shell&)>>;

std::vector<Service> all_services() {
    static const CartPos pose = CartPos::Identity();
    static const JointPos joints = JointPos::Zero(5);
    static CartPos pose_out;
    static JointPos joints_out;
    static std::string text;
    static double seconds;
    static int event;
    static TargetId target;
    return {
        {"Initialize", [](Shell& s) { return s.Initialize(); }},
        {"Reset", [](Shell& s) { return s.Reset(); }},
        {"Terminate", [](Shell& s) { return s.Terminate(); }},
        {"GetMessage", [](Shell& s) { return s.GetMessage(text); }},
        {"GetInverseKinematics", [](Shell& s) { return s.GetInverseKinematics(pose, joints, joints_out); }},
        {"GetForwardKinematics", [](Shell& s) { return s.GetForwardKinematics(joints, pose_out); }},
        {"GetCellFrame", [](Shell& s) { return s.GetCellFrame("BASE", pose_out); }},
        {"ModifyCellFrame", [](Shell& s) { return s.ModifyCellFrame("TOOL", pose); }},
        {"SelectWorkFrames", [](Shell& s) { return s.SelectWorkFrames("TOOL", "BASE"); }},
        {"SelectTargetType", [](Shell& s) { return s.SelectTargetType(TargetType::joint); }},
        {"SelectTrajectoryMode", [](Shell& s) { return s.SelectTrajectoryMode(0); }},
        {"SetInitialPosition", [](Shell& s) { return s.SetInitialPosition(pose, joints, ""); }},
        {"SetNextTarget", [](Shell& s) { return s.SetNextTarget(1, TargetParam::end, pose, joints, "", 0); }},
        {"SetNextNamedTarget",
         [](Shell& s) { return s.SetNextNamedTarget(1, TargetParam::end, pose, joints, "", 0, "P1"); }},
        {"GetNextStep", [](Shell& s) { return s.GetNextStep(joints_out, pose_out, seconds); }},
        {"SetInterpolationTime", [](Shell& s) { return s.SetInterpolationTime(0.01); }},
        {"StopMotion", [](Shell& s) { return s.StopMotion(); }},
        {"ContinueMotion", [](Shell& s) { return s.ContinueMotion(); }},
        {"CancelMotion", [](Shell& s) { return s.CancelMotion(); }},
        {"SelectMotionType", [](Shell& s) { return s.SelectMotionType(MotionType::linear); }},
        {"SelectOrientationInterpolationMode",
         [](Shell& s) { return s.SelectOrientationInterpolationMode(1); }},
        {"SelectDominantInterpolation",
         [](Shell& s) { return s.SelectDominantInterpolation(Dominance::automatic); }},
        {"SetJointSpeeds", [](Shell& s) { return s.SetJointSpeeds({}, {}); }},
        {"SetJointAccelerations", [](Shell& s) { return s.SetJointAccelerations({}, {}); }},
        {"SetJointJerks", [](Shell& s) { return s.SetJointJerks({}, {}); }},
        {"SetCartesianPositionSpeed", [](Shell& s) { return s.SetCartesianPositionSpeed(1); }},
        {"SetCartesianOrientationSpeed", [](Shell& s) { return s.SetCartesianOrientationSpeed(1); }},
        {"SetCartesianPositionAcceleration", [](Shell& s) { return s.SetCartesianPositionAcceleration(1); }},
        {"SetCartesianOrientationAcceleration",
         [](Shell& s) { return s.SetCartesianOrientationAcceleration(1); }},
        {"SetOverrideSpeed", [](Shell& s) { return s.SetOverrideSpeed(100); }},
        {"SetOverrideAcceleration", [](Shell& s) { return s.SetOverrideAcceleration(100); }},
        {"SetMotionTime", [](Shell& s) { return s.SetMotionTime(1); }},
        {"SetRestParameter", [](Shell& s) { return s.SetRestParameter(1); }},
        {"SelectFlybyMode", [](Shell& s) { return s.SelectFlybyMode(false); }},
        {"SelectFlybyCriteria", [](Shell& s) { return s.SelectFlybyCriteria(1); }},
        {"SetFlybyCriteriaParameter", [](Shell& s) { return s.SetFlybyCriteriaParameter(1, -1, 0); }},
        {"CancelFlybyCriteria", [](Shell& s) { return s.CancelFlybyCriteria(1); }},
        {"SelectPointAccuracy", [](Shell& s) { return s.SelectPointAccuracy(1); }},
        {"SetPointAccuracyParameter", [](Shell& s) { return s.SetPointAccuracyParameter(1, 0); }},
        {"DefineEvent", [](Shell& s) { return s.DefineEvent(1, 1, 0); }},
        {"CancelEvent", [](Shell& s) { return s.CancelEvent(1); }},
        {"GetEvent", [](Shell& s) { return s.GetEvent(0, event, seconds); }},
        {"SelectTracking", [](Shell& s) { return s.SelectTracking(0, true); }},
        {"SetConveyorPosition", [](Shell& s) { return s.SetConveyorPosition(0, 0); }},
        {"DefineConveyor", [](Shell& s) { return s.DefineConveyor(0, Eigen::Vector3d::UnitX(), 1); }},
        {"SetObjectInitialPosition", [](Shell& s) { return s.SetObjectInitialPosition(pose); }},
        {"SetObjectSpeed", [](Shell& s) { return s.SetObjectSpeed(1); }},
        {"SetObjectNextTarget", [](Shell& s) { return s.SetObjectNextTarget(1, pose); }},
        {"GetNextObjectStep", [](Shell& s) { return s.GetNextObjectStep(pose_out, seconds); }},
        {"SetRapid", [](Shell& s) { return s.SetRapid(true); }},
        {"SetNextArcTarget",
         [](Shell& s) {
             return s.SetNextArcTarget(1, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), 1, pose, joints);
         }},
        {"SetNextRest", [](Shell& s) { return s.SetNextRest(1, 0); }},
        {"SetPathMode", [](Shell& s) { return s.SetPathMode(PathMode::exact_path, 0, 0); }},
        {"GetTargetOfLastStep", [](Shell& s) { return s.GetTargetOfLastStep(target); }},
        {"SetTipControl", [](Shell& s) { return s.SetTipControl(true, Eigen::Vector3d::Zero()); }},
        {"ComeToRest", [](Shell& s) { return s.ComeToRest(RestReason::query); }},
    };
}

TEST(Shell, every_service_without_an_implementation_says_so_by_its_name) {
    for (const auto& [name, call] : all_services()) {
        BareShell shell;
        EXPECT_EQ(call(shell), Status::RRS_SERVICE_NOT_SUPPORTED) << name;
        EXPECT_EQ(shell.asked, name);
    }
}

}  // namespace
}  // namespace gsim::rrs::shell_test
