// Services of PlannerShell that set values for the targets to come, and its kinematics.

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "motion/kinematics/pose.h"
#include "motion/path/master_path.h"
#include "motion/services/planner_shell.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kMinServiceTime_s = 1e-6;
constexpr double kMaxPercent = 200;

}  // namespace

Status PlannerShell::GetInverseKinematics(const rrs::CartPos& pose, const rrs::JointPos& near,
                                          rrs::JointPos& joints) {
    if (!initialized_) return not_initialized();
    if (auto checked = kinematics::check_pose(pose); !checked) {
        return reject(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    }
    if (PlanResult checked = planner_.check_joints(near); !checked)
        return to_status(std::move(checked.error()));
    auto solution = planner_.setup().kinematics->inverse(selections_.frames.to_tool_centre(pose), near);
    if (!solution) return reject(Status::RRS_NO_SOLUTION, std::move(solution.error()));
    joints = *solution;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::GetForwardKinematics(const rrs::JointPos& joints, rrs::CartPos& pose) {
    if (!initialized_) return not_initialized();
    if (PlanResult checked = planner_.check_joints(joints); !checked)
        return to_status(std::move(checked.error()));
    pose = selections_.frames.to_target(planner_.setup().kinematics->forward(joints));
    return Status::RRS_SUCCESS;
}

// This planner has only one.
Status PlannerShell::SelectTrajectoryMode(int mode) {
    return Shell::SelectTrajectoryMode(mode);
}

Status PlannerShell::SelectTargetType(rrs::TargetType type) {
    if (!initialized_) return not_initialized();
    if (type != rrs::TargetType::cartesian && type != rrs::TargetType::joint) {
        return reject(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no target type {}; 0 is Cartesian, 1 joint.", static_cast<int>(type)));
    }
    selections_.target_type = type;
    if (type == rrs::TargetType::joint && !planner_.setup().has_position_joints())
        selections_.motion_type = rrs::MotionType::joint;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SelectMotionType(rrs::MotionType type) {
    if (!initialized_) return not_initialized();
    const bool path = type == rrs::MotionType::linear || type == rrs::MotionType::circular;
    if (!path && type != rrs::MotionType::joint) {
        return reject(Status::RRS_INVALID_PARAMETER,
                      fmt::format("There is no motion type {}; 1 is joint, 2 linear, 4 circular.",
                                  static_cast<int>(type)));
    }
    const bool targets_poses = selections_.target_type == rrs::TargetType::cartesian;
    if (path && !planner_.setup().has_position_joints() &&
        !(targets_poses && rotary_joints_move_tcp(planner_.setup(), selections_.frames.tcp_mm()))) {
        return reject(
            Status::RRS_MOTION_TYPE_NOT_SUPPORTED,
            "Linear and circular motion to joint values need joints that carry the position of the tool; "
            "this machine has none.");
    }
    selections_.motion_type = type;
    via_.reset();
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SelectDominantInterpolation(rrs::Dominance dominance) {
    if (!initialized_) return not_initialized();
    const int number = static_cast<int>(dominance);
    if (number < 0 || number > 2) {
        return reject(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no dominance {}; 0 is automatic, 1 position, 2 orientation.", number));
    }
    selections_.move_parameters.dominance = dominance;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SelectFlybyMode(bool on) {
    if (!initialized_) return not_initialized();
    if (on && !planner_.can_pass_targets())
        return reject(Status::RRS_MODE_NOT_SUPPORTED,
                      "The default planner stops at each target; it has no fly-by.");
    selections_.move_parameters.path_mode = on ? rrs::PathMode::continuous : rrs::PathMode::exact_stop;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetPathMode(rrs::PathMode mode, double tolerance_mm, double merge_tolerance_mm) {
    if (!initialized_) return not_initialized();
    const int number = static_cast<int>(mode);
    if (number < 0 || number > 2) {
        return reject(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no path mode {}; 0 is exact stop, 1 exact path, 2 continuous.", number));
    }
    if (!(tolerance_mm >= 0 && tolerance_mm < kUnlimited && merge_tolerance_mm >= 0 &&
          merge_tolerance_mm < kUnlimited)) {
        return reject(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The tolerances of a path are 0 or greater; {} and {} were asked for.",
                                  tolerance_mm, merge_tolerance_mm));
    }
    selections_.move_parameters.path_mode = mode;
    selections_.move_parameters.tolerance_mm = tolerance_mm;
    selections_.move_parameters.merge_tolerance_mm = merge_tolerance_mm;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetRapid(bool on) {
    if (!initialized_) return not_initialized();
    selections_.move_parameters.rapid = on;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetInterpolationTime(double interpolation_s) {
    if (!initialized_) return not_initialized();
    if (!(interpolation_s >= kMinServiceTime_s && interpolation_s <= kMaxDuration_s)) {
        return reject(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The interpolation time is from {} to {} s; {} was asked for.",
                                  kMinServiceTime_s, kMaxDuration_s, interpolation_s));
    }
    selections_.interpolation_s = interpolation_s;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetJointSpeeds(std::span<const int> joints, std::span<const double> speeds) {
    return set_joint_parameters(&JointParameters::speeds, joints, speeds, "speed");
}

Status PlannerShell::SetJointAccelerations(std::span<const int> joints,
                                           std::span<const double> accelerations) {
    return set_joint_parameters(&JointParameters::accelerations, joints, accelerations, "acceleration");
}

Status PlannerShell::SetJointJerks(std::span<const int> joints, std::span<const double> jerks) {
    return set_joint_parameters(&JointParameters::jerks, joints, jerks, "jerk");
}

Status PlannerShell::SetRampMode(rrs::RampMode mode) {
    if (!initialized_) return not_initialized();
    const int number = static_cast<int>(mode);
    if (number < 0 || number > 3) {
        return reject(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no ramp mode {}; 0 is the machine's own, 1 linear, 2 S-curve, 3 infinite.",
                        number));
    }
    if (mode != rrs::RampMode::machine) {
        if (PlanResult checked = planner_.check_ramps(); !checked)
            return to_status(std::move(checked.error()));
    }
    ProgrammedRamps changed = ramps();
    changed.mode = mode;
    set_ramps(changed);
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetJointRampLimits(rrs::RampLimit limit, std::span<const int> joints,
                                        std::span<const double> values) {
    if (!initialized_) return not_initialized();
    const int number = static_cast<int>(limit);
    if (number < 0 || number > 2) {
        return reject(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no limit {}; 0 is acceleration, 1 deceleration, 2 jerk.", number));
    }
    if (PlanResult checked = planner_.check_ramps(); !checked) return to_status(std::move(checked.error()));
    constexpr std::string_view kNames[] = {"acceleration", "deceleration", "jerk"};
    ProgrammedRamps changed = ramps();
    const Status status = set_joint_values(changed.of(limit), joints, values, kNames[number]);
    if (status == Status::RRS_SUCCESS) set_ramps(changed);
    return status;
}

ProgrammedRamps PlannerShell::ramps() const {
    return selections_.move_parameters.ramps ? *selections_.move_parameters.ramps
                                             : ProgrammedRamps(planner_.setup().joint_count());
}

void PlannerShell::set_ramps(const ProgrammedRamps& ramps) {
    selections_.move_parameters.ramps = std::make_shared<const ProgrammedRamps>(ramps);
    planner_.use(selections_.move_parameters);
}

Status PlannerShell::SetCartesianPositionSpeed(double speed_mm_s) {
    return set_positive(selections_.move_parameters.position_speed_mm_s, speed_mm_s, "speed");
}

Status PlannerShell::SetCartesianOrientationSpeed(double speed_rad_s) {
    return set_positive(selections_.move_parameters.orientation_speed_rad_s, speed_rad_s,
                        "orientation speed");
}

Status PlannerShell::SetCartesianPositionAcceleration(double acceleration_mm_s2) {
    return set_positive(selections_.move_parameters.position_acceleration_mm_s2, acceleration_mm_s2,
                        "acceleration");
}

Status PlannerShell::SetCartesianOrientationAcceleration(double acceleration_rad_s2) {
    return set_positive(selections_.move_parameters.orientation_acceleration_rad_s2, acceleration_rad_s2,
                        "orientation acceleration");
}

Status PlannerShell::SetOverrideSpeed(double percent) {
    return set_percent(selections_.move_parameters.speed_override, percent, "speed");
}

Status PlannerShell::SetOverrideAcceleration(double percent) {
    return set_percent(selections_.move_parameters.acceleration_override, percent, "acceleration");
}

Status PlannerShell::SetMotionTime(double motion_s) {
    if (!initialized_) return not_initialized();
    if (PlanResult checked = check_motion_time(motion_s); !checked)
        return to_status(std::move(checked.error()));
    selections_.move_parameters.motion_time_s = motion_s;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetRestParameter(double dwell_s) {
    if (!initialized_) return not_initialized();
    if (!(dwell_s >= 0 && dwell_s <= kMaxDuration_s)) {
        return reject(Status::RRS_INVALID_PARAMETER,
                      fmt::format("A rest takes from 0 to {} s; {} was asked for.", kMaxDuration_s, dwell_s));
    }
    selections_.dwell_s = dwell_s;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::set_positive(double& value, double requested, std::string_view what) {
    if (!initialized_) return not_initialized();
    if (PlanResult checked = check_positive(requested, what); !checked)
        return to_status(std::move(checked.error()));
    value = requested;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::set_percent(double& factor, double percent, std::string_view what) {
    if (!initialized_) return not_initialized();
    if (!(percent > 0 && percent <= kMaxPercent)) {
        return reject(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The {} override is above 0 and at most {} percent; {} was asked for.",
                                  what, kMaxPercent, percent));
    }
    factor = percent / 100;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::set_joint_values(rrs::JointPos& values, std::span<const int> joints,
                                      std::span<const double> requested, std::string_view what) {
    if (!initialized_) return not_initialized();
    const std::size_t count = joints.empty() ? planner_.setup().joints.size() : joints.size();
    if (requested.size() != count) {
        return reject(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("{} values were given for the {} of {} joints.", requested.size(), what, count));
    }
    rrs::JointPos changed = values;
    for (std::size_t i = 0; i < count; ++i) {
        const int joint = joints.empty() ? static_cast<int>(i) : joints[i];
        if (joint < 0 || joint >= planner_.setup().joint_count()) {
            return reject(Status::RRS_INVALID_PARAMETER,
                          fmt::format("There is no joint {}; joints are 0 to {}.", joint,
                                      planner_.setup().joint_count() - 1));
        }
        if (!(requested[i] > 0)) {
            return reject(Status::RRS_INVALID_PARAMETER,
                          fmt::format("The {} of joint {} must be greater than 0; {} was asked for.", what,
                                      joint, requested[i]));
        }
        changed[joint] = requested[i];
    }
    values = changed;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::set_joint_parameters(rrs::JointPos JointParameters::*values, std::span<const int> joints,
                                          std::span<const double> requested, std::string_view what) {
    JointParameters changed = selections_.move_parameters.joints
                                  ? *selections_.move_parameters.joints
                                  : JointParameters(planner_.setup().joint_count());
    const Status status = set_joint_values(changed.*values, joints, requested, what);
    if (status == Status::RRS_SUCCESS)
        selections_.move_parameters.joints = std::make_shared<const JointParameters>(std::move(changed));
    return status;
}

Status PlannerShell::SetTipControl(bool on, const Eigen::Vector3d& tcp_mm) {
    if (!initialized_) return not_initialized();
    if (!tcp_mm.allFinite())
        return reject(Status::RRS_INVALID_PARAMETER, "The place of the tip is not finite.");
    if (!on) {
        selections_.tcp_mm.reset();
        return Status::RRS_SUCCESS;
    }
    if (PlanResult checked = planner_.check_tcp_control(); !checked)
        return to_status(std::move(checked.error()));
    selections_.tcp_mm = tcp_mm;
    return Status::RRS_SUCCESS;
}

}  // namespace gsim::motion
