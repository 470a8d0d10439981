// Services of PlannerShell that set values for the targets to come, and its kinematics.

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "motion/kinematics/pose.h"
#include "motion/path/lead_path.h"
#include "motion/services/planner_shell.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kLeastServiceTime_s = 1e-6;
constexpr double kMaxPercent = 200;

}  // namespace

Status PlannerShell::GetInverseKinematics(const rrs::CartPos& pose, const rrs::JointPos& near,
                                          rrs::JointPos& joints) {
    if (!initialized_) return not_initialized();
    if (auto checked = kinematics::check_pose(pose); !checked) {
        return refuse(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    }
    if (Planned checked = planner_.check_joints(near); !checked) return tell(std::move(checked.error()));
    auto solution = planner_.setup().kinematics->inverse(selections_.frames.tool_centre_of(pose), near);
    if (!solution) return refuse(Status::RRS_NO_SOLUTION, std::move(solution.error()));
    joints = *solution;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::GetForwardKinematics(const rrs::JointPos& joints, rrs::CartPos& pose) {
    if (!initialized_) return not_initialized();
    if (Planned checked = planner_.check_joints(joints); !checked) return tell(std::move(checked.error()));
    pose = selections_.frames.target_of(planner_.setup().kinematics->forward(joints));
    return Status::RRS_SUCCESS;
}

// This planner has only one.
Status PlannerShell::SelectTrajectoryMode(int mode) {
    return Shell::SelectTrajectoryMode(mode);
}

Status PlannerShell::SelectTargetType(rrs::TargetType type) {
    if (!initialized_) return not_initialized();
    if (type != rrs::TargetType::cartesian && type != rrs::TargetType::joint) {
        return refuse(
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
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("There is no motion type {}; 1 is joint, 2 linear, 4 circular.",
                                  static_cast<int>(type)));
    }
    const bool to_poses = selections_.target_type == rrs::TargetType::cartesian;
    if (path && !planner_.setup().has_position_joints() &&
        !(to_poses && tip_turns(planner_.setup(), selections_.frames.tip_mm()))) {
        return refuse(
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
        return refuse(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no dominance {}; 0 is automatic, 1 position, 2 orientation.", number));
    }
    selections_.terms.dominance = dominance;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SelectFlybyMode(bool on) {
    if (!initialized_) return not_initialized();
    if (on && !planner_.passes_targets())
        return refuse(Status::RRS_MODE_NOT_SUPPORTED,
                      "The default planner stops at each target; it has no fly-by.");
    selections_.terms.path_mode = on ? rrs::PathMode::continuous : rrs::PathMode::exact_stop;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetPathMode(rrs::PathMode mode, double tolerance_mm, double merge_tolerance_mm) {
    if (!initialized_) return not_initialized();
    const int number = static_cast<int>(mode);
    if (number < 0 || number > 2) {
        return refuse(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no path mode {}; 0 is exact stop, 1 exact path, 2 continuous.", number));
    }
    if (!(tolerance_mm >= 0 && tolerance_mm < kUnlimited && merge_tolerance_mm >= 0 &&
          merge_tolerance_mm < kUnlimited)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The tolerances of a path are 0 or greater; {} and {} were asked for.",
                                  tolerance_mm, merge_tolerance_mm));
    }
    selections_.terms.path_mode = mode;
    selections_.terms.tolerance_mm = tolerance_mm;
    selections_.terms.merge_tolerance_mm = merge_tolerance_mm;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetRapid(bool on) {
    if (!initialized_) return not_initialized();
    selections_.terms.rapid = on;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetInterpolationTime(double interpolation_s) {
    if (!initialized_) return not_initialized();
    if (!(interpolation_s >= kLeastServiceTime_s && interpolation_s <= kLongest_s)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The interpolation time is from {} to {} s; {} was asked for.",
                                  kLeastServiceTime_s, kLongest_s, interpolation_s));
    }
    selections_.interpolation_s = interpolation_s;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetJointSpeeds(std::span<const int> joints, std::span<const double> speeds) {
    return set_joint_terms(&JointTerms::speeds, joints, speeds, "speed");
}

Status PlannerShell::SetJointAccelerations(std::span<const int> joints,
                                           std::span<const double> accelerations) {
    return set_joint_terms(&JointTerms::accelerations, joints, accelerations, "acceleration");
}

Status PlannerShell::SetJointJerks(std::span<const int> joints, std::span<const double> jerks) {
    return set_joint_terms(&JointTerms::jerks, joints, jerks, "jerk");
}

Status PlannerShell::SetRampMode(rrs::RampMode mode) {
    if (!initialized_) return not_initialized();
    const int number = static_cast<int>(mode);
    if (number < 0 || number > 3) {
        return refuse(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no ramp mode {}; 0 is the machine's own, 1 linear, 2 S-curve, 3 infinite.",
                        number));
    }
    if (mode != rrs::RampMode::machine) {
        if (Planned checked = planner_.check_ramps(); !checked) return tell(std::move(checked.error()));
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
        return refuse(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no limit {}; 0 is acceleration, 1 deceleration, 2 jerk.", number));
    }
    if (Planned checked = planner_.check_ramps(); !checked) return tell(std::move(checked.error()));
    constexpr std::string_view kNames[] = {"acceleration", "deceleration", "jerk"};
    ProgrammedRamps changed = ramps();
    const Status status = set_joint_values(changed.of(limit), joints, values, kNames[number]);
    if (status == Status::RRS_SUCCESS) set_ramps(changed);
    return status;
}

ProgrammedRamps PlannerShell::ramps() const {
    return selections_.terms.ramps ? *selections_.terms.ramps
                                   : ProgrammedRamps(planner_.setup().joint_count());
}

void PlannerShell::set_ramps(const ProgrammedRamps& ramps) {
    selections_.terms.ramps = std::make_shared<const ProgrammedRamps>(ramps);
    planner_.use(selections_.terms);
}

Status PlannerShell::SetCartesianPositionSpeed(double speed_mm_s) {
    return set_positive(selections_.terms.position_speed_mm_s, speed_mm_s, "speed");
}

Status PlannerShell::SetCartesianOrientationSpeed(double speed_rad_s) {
    return set_positive(selections_.terms.orientation_speed_rad_s, speed_rad_s, "orientation speed");
}

Status PlannerShell::SetCartesianPositionAcceleration(double acceleration_mm_s2) {
    return set_positive(selections_.terms.position_acceleration_mm_s2, acceleration_mm_s2, "acceleration");
}

Status PlannerShell::SetCartesianOrientationAcceleration(double acceleration_rad_s2) {
    return set_positive(selections_.terms.orientation_acceleration_rad_s2, acceleration_rad_s2,
                        "orientation acceleration");
}

Status PlannerShell::SetOverrideSpeed(double percent) {
    return set_percent(selections_.terms.speed_override, percent, "speed");
}

Status PlannerShell::SetOverrideAcceleration(double percent) {
    return set_percent(selections_.terms.acceleration_override, percent, "acceleration");
}

Status PlannerShell::SetMotionTime(double motion_s) {
    if (!initialized_) return not_initialized();
    if (Planned checked = check_motion_time(motion_s); !checked) return tell(std::move(checked.error()));
    selections_.terms.motion_time_s = motion_s;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::SetRestParameter(double rest_s) {
    if (!initialized_) return not_initialized();
    if (!(rest_s >= 0 && rest_s <= kLongest_s)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("A rest takes from 0 to {} s; {} was asked for.", kLongest_s, rest_s));
    }
    selections_.rest_s = rest_s;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::set_positive(double& value, double wanted, std::string_view what) {
    if (!initialized_) return not_initialized();
    if (Planned checked = check_positive(wanted, what); !checked) return tell(std::move(checked.error()));
    value = wanted;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::set_percent(double& factor, double percent, std::string_view what) {
    if (!initialized_) return not_initialized();
    if (!(percent > 0 && percent <= kMaxPercent)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The {} override is above 0 and at most {} percent; {} was asked for.",
                                  what, kMaxPercent, percent));
    }
    factor = percent / 100;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::set_joint_values(rrs::JointPos& values, std::span<const int> joints,
                                      std::span<const double> wanted, std::string_view what) {
    if (!initialized_) return not_initialized();
    const std::size_t count = joints.empty() ? planner_.setup().joints.size() : joints.size();
    if (wanted.size() != count) {
        return refuse(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("{} values were given for the {} of {} joints.", wanted.size(), what, count));
    }
    rrs::JointPos changed = values;
    for (std::size_t i = 0; i < count; ++i) {
        const int joint = joints.empty() ? static_cast<int>(i) : joints[i];
        if (joint < 0 || joint >= planner_.setup().joint_count()) {
            return refuse(Status::RRS_INVALID_PARAMETER,
                          fmt::format("There is no joint {}; joints are 0 to {}.", joint,
                                      planner_.setup().joint_count() - 1));
        }
        if (!(wanted[i] > 0)) {
            return refuse(Status::RRS_INVALID_PARAMETER,
                          fmt::format("The {} of joint {} must be greater than 0; {} was asked for.", what,
                                      joint, wanted[i]));
        }
        changed[joint] = wanted[i];
    }
    values = changed;
    return Status::RRS_SUCCESS;
}

Status PlannerShell::set_joint_terms(rrs::JointPos JointTerms::*values, std::span<const int> joints,
                                     std::span<const double> wanted, std::string_view what) {
    JointTerms changed =
        selections_.terms.joints ? *selections_.terms.joints : JointTerms(planner_.setup().joint_count());
    const Status status = set_joint_values(changed.*values, joints, wanted, what);
    if (status == Status::RRS_SUCCESS)
        selections_.terms.joints = std::make_shared<const JointTerms>(std::move(changed));
    return status;
}

Status PlannerShell::SetTipControl(bool on, const Eigen::Vector3d& tip_mm) {
    if (!initialized_) return not_initialized();
    if (!tip_mm.allFinite())
        return refuse(Status::RRS_INVALID_PARAMETER, "The place of the tip is not finite.");
    if (!on) {
        selections_.tip_mm.reset();
        return Status::RRS_SUCCESS;
    }
    if (Planned checked = planner_.check_tip_control(); !checked) return tell(std::move(checked.error()));
    selections_.tip_mm = tip_mm;
    return Status::RRS_SUCCESS;
}

}  // namespace gsim::motion
