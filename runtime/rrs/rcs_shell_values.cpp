// The services of a controller module that select and set values.

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "runtime/rrs/rcs_shell.h"
#include "runtime/rrs/rcs_values.h"

namespace gsim::rrs {

Status RcsShell::SelectMotionType(MotionType type) {
    return ask_integer({GSIM_RCS_SELECT_MOTION_TYPE, "SelectMotionType"}, static_cast<int>(type));
}

Status RcsShell::SelectDominantInterpolation(Dominance dominance) {
    return ask_integer({GSIM_RCS_SELECT_DOMINANT_INTERPOLATION, "SelectDominantInterpolation"},
                       static_cast<int>(dominance));
}

Status RcsShell::SelectOrientationInterpolationMode(int mode) {
    return ask_integer({GSIM_RCS_SELECT_ORIENTATION_INTERPOLATION_MODE, "SelectOrientationInterpolationMode"},
                       mode);
}

Status RcsShell::SetJointSpeeds(std::span<const int> joints, std::span<const double> speeds) {
    return ask_joint_values({GSIM_RCS_SET_JOINT_SPEEDS, "SetJointSpeeds"}, joints, speeds);
}

Status RcsShell::SetJointAccelerations(std::span<const int> joints, std::span<const double> accelerations) {
    return ask_joint_values({GSIM_RCS_SET_JOINT_ACCELERATIONS, "SetJointAccelerations"}, joints,
                            accelerations);
}

Status RcsShell::SetJointJerks(std::span<const int> joints, std::span<const double> jerks) {
    return ask_joint_values({GSIM_RCS_SET_JOINT_JERKS, "SetJointJerks"}, joints, jerks);
}

Status RcsShell::SetCartesianPositionSpeed(double speed_mm_s) {
    return ask_number({GSIM_RCS_SET_CARTESIAN_POSITION_SPEED, "SetCartesianPositionSpeed"}, speed_mm_s);
}

Status RcsShell::SetCartesianOrientationSpeed(double speed_rad_s) {
    return ask_number({GSIM_RCS_SET_CARTESIAN_ORIENTATION_SPEED, "SetCartesianOrientationSpeed"},
                      speed_rad_s);
}

Status RcsShell::SetCartesianPositionAcceleration(double acceleration_mm_s2) {
    return ask_number({GSIM_RCS_SET_CARTESIAN_POSITION_ACCELERATION, "SetCartesianPositionAcceleration"},
                      acceleration_mm_s2);
}

Status RcsShell::SetCartesianOrientationAcceleration(double acceleration_rad_s2) {
    return ask_number(
        {GSIM_RCS_SET_CARTESIAN_ORIENTATION_ACCELERATION, "SetCartesianOrientationAcceleration"},
        acceleration_rad_s2);
}

Status RcsShell::SetOverrideSpeed(double percent) {
    return ask_number({GSIM_RCS_SET_OVERRIDE_SPEED, "SetOverrideSpeed"}, percent);
}

Status RcsShell::SetOverrideAcceleration(double percent) {
    return ask_number({GSIM_RCS_SET_OVERRIDE_ACCELERATION, "SetOverrideAcceleration"}, percent);
}

Status RcsShell::SetMotionTime(double motion_s) {
    return ask_number({GSIM_RCS_SET_MOTION_TIME, "SetMotionTime"}, motion_s);
}

Status RcsShell::SetRestParameter(double rest_s) {
    return ask_number({GSIM_RCS_SET_REST_PARAMETER, "SetRestParameter"}, rest_s);
}

Status RcsShell::SelectFlybyMode(bool on) {
    return ask_integer({GSIM_RCS_SELECT_FLYBY_MODE, "SelectFlybyMode"}, on ? 1 : 0);
}

Status RcsShell::SelectFlybyCriteria(int criterion) {
    return ask_integer({GSIM_RCS_SELECT_FLYBY_CRITERIA, "SelectFlybyCriteria"}, criterion);
}

Status RcsShell::SetFlybyCriteriaParameter(int criterion, int joint, double value) {
    const gsim_rcs_parameter_value input{criterion, joint, value};
    return ask({GSIM_RCS_SET_FLYBY_CRITERIA_PARAMETER, "SetFlybyCriteriaParameter"}, &input, nullptr);
}

Status RcsShell::CancelFlybyCriteria(int criterion) {
    return ask_integer({GSIM_RCS_CANCEL_FLYBY_CRITERIA, "CancelFlybyCriteria"}, criterion);
}

Status RcsShell::SelectPointAccuracy(int accuracy_type) {
    return ask_integer({GSIM_RCS_SELECT_POINT_ACCURACY, "SelectPointAccuracy"}, accuracy_type);
}

Status RcsShell::SetPointAccuracyParameter(int accuracy_type, double value) {
    const gsim_rcs_parameter_value input{accuracy_type, 0, value};
    return ask({GSIM_RCS_SET_POINT_ACCURACY_PARAMETER, "SetPointAccuracyParameter"}, &input, nullptr);
}

Status RcsShell::DefineEvent(int event_id, TargetId target, double offset_s) {
    const gsim_rcs_event_definition input{target, event_id, 0, offset_s};
    return ask({GSIM_RCS_DEFINE_EVENT, "DefineEvent"}, &input, nullptr);
}

Status RcsShell::CancelEvent(int event_id) {
    return ask_integer({GSIM_RCS_CANCEL_EVENT, "CancelEvent"}, event_id);
}

Status RcsShell::GetEvent(int number, int& event_id, double& time_s) {
    const Service service{GSIM_RCS_GET_EVENT, "GetEvent"};
    const gsim_rcs_integer input{number};
    gsim_rcs_event output{0, 0, std::numeric_limits<double>::quiet_NaN()};
    const Status status = ask(service, &input, &output);
    if (status != Status::RRS_SUCCESS) return status;
    if (!(output.time_s <= interpolation_s_ && std::isfinite(output.time_s))) {
        return blame(fmt::format("answered {} with the time {} s; the interpolation time is {} s",
                                 service.name, output.time_s, interpolation_s_));
    }
    event_id = output.event;
    time_s = output.time_s;
    return status;
}

Status RcsShell::SelectTracking(int conveyor, bool on) {
    const gsim_rcs_tracking input{conveyor, on ? 1 : 0};
    return ask({GSIM_RCS_SELECT_TRACKING, "SelectTracking"}, &input, nullptr);
}

Status RcsShell::SetConveyorPosition(int conveyor, double position_mm) {
    const gsim_rcs_parameter_value input{conveyor, 0, position_mm};
    return ask({GSIM_RCS_SET_CONVEYOR_POSITION, "SetConveyorPosition"}, &input, nullptr);
}

Status RcsShell::SetObjectSpeed(double speed_mm_s) {
    return ask_number({GSIM_RCS_SET_OBJECT_SPEED, "SetObjectSpeed"}, speed_mm_s);
}

Status RcsShell::SetObjectNextTarget(TargetId id, const CartPos& pose) {
    const gsim_rcs_object_target input{id, to_rcs(pose)};
    return ask({GSIM_RCS_SET_OBJECT_NEXT_TARGET, "SetObjectNextTarget"}, &input, nullptr);
}

Status RcsShell::GetNextObjectStep(CartPos& pose, double& elapsed_s) {
    const Service service{GSIM_RCS_GET_NEXT_OBJECT_STEP, "GetNextObjectStep"};
    gsim_rcs_object_step output{};
    output.pose.matrix[0] = output.elapsed_s = std::numeric_limits<double>::quiet_NaN();
    const Status status = ask(service, nullptr, &output, Extra::step);
    if (is_refused(status)) return status;
    for (const Status check :
         {checked_elapsed(service, output.elapsed_s, elapsed_s), checked(service, output.pose, pose)}) {
        if (check != Status::RRS_SUCCESS) return check;
    }
    return status;
}

Status RcsShell::SetRapid(bool on) {
    return ask_integer({GSIM_RCS_SET_RAPID, "SetRapid"}, on ? 1 : 0);
}

Status RcsShell::SetPathMode(PathMode mode, double tolerance_mm, double merge_tolerance_mm) {
    const gsim_rcs_path_mode input{static_cast<int>(mode), 0, tolerance_mm, merge_tolerance_mm};
    return ask({GSIM_RCS_SET_PATH_MODE, "SetPathMode"}, &input, nullptr);
}

Status RcsShell::SetRampMode(RampMode mode) {
    return ask_integer({GSIM_RCS_SET_RAMP_MODE, "SetRampMode"}, static_cast<int>(mode));
}

Status RcsShell::SetJointRampLimits(RampLimit limit, std::span<const int> joints,
                                    std::span<const double> values) {
    const Service service{GSIM_RCS_SET_JOINT_RAMP_LIMITS, "SetJointRampLimits"};
    gsim_rcs_ramp_limits input{static_cast<int>(limit), 0, {}};
    const Status status = put_joint_values(service, joints, values, input.values);
    return status == Status::RRS_SUCCESS ? ask(service, &input, nullptr) : status;
}

Status RcsShell::DefinePathEvent(int event_id, TargetId target, double offset_mm) {
    const gsim_rcs_path_event_definition input{target, event_id, 0, offset_mm};
    return ask({GSIM_RCS_DEFINE_PATH_EVENT, "DefinePathEvent"}, &input, nullptr);
}

}  // namespace gsim::rrs
