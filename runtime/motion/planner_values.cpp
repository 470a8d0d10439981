// The services of DefaultPlanner that select and set what holds for the targets to come, and its kinematics.

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "runtime/kinematics/pose.h"
#include "runtime/motion/lead_path.h"
#include "runtime/motion/planner.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kLeastTime_s = 1e-6;
constexpr double kMaxPercent = 200;

}  // namespace

Status DefaultPlanner::GetInverseKinematics(const rrs::CartPos& pose, const rrs::JointPos& near,
                                            rrs::JointPos& joints) {
    if (!initialized_) return not_initialized();
    if (auto checked = kinematics::check_pose(pose); !checked) {
        return refuse(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    }
    rrs::JointPos valid_near;
    if (Planned solved = solve_joints(near, valid_near); !solved) return tell(std::move(solved.error()));
    auto solution = setup_.kinematics->inverse(work_frames_.tool_centre_of(pose), valid_near);
    if (!solution) return refuse(Status::RRS_NO_SOLUTION, std::move(solution.error()));
    joints = *solution;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::GetForwardKinematics(const rrs::JointPos& joints, rrs::CartPos& pose) {
    if (!initialized_) return not_initialized();
    rrs::JointPos valid;
    if (Planned solved = solve_joints(joints, valid); !solved) return tell(std::move(solved.error()));
    pose = work_frames_.target_of(setup_.kinematics->forward(valid));
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SelectTargetType(rrs::TargetType type) {
    if (!initialized_) return not_initialized();
    if (type != rrs::TargetType::cartesian && type != rrs::TargetType::joint) {
        return refuse(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no target type {}; 0 is Cartesian, 1 joint.", static_cast<int>(type)));
    }
    programmed_.target_type = type;
    if (type == rrs::TargetType::joint && !setup_.has_position_joints())
        programmed_.motion_type = rrs::MotionType::joint;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SelectMotionType(rrs::MotionType type) {
    if (!initialized_) return not_initialized();
    const bool path = type == rrs::MotionType::linear || type == rrs::MotionType::circular;
    if (!path && type != rrs::MotionType::joint) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("There is no motion type {}; 1 is joint, 2 linear, 4 circular.",
                                  static_cast<int>(type)));
    }
    const bool to_poses = programmed_.target_type == rrs::TargetType::cartesian;
    if (path && !setup_.has_position_joints() && !(to_poses && tip_turns_)) {
        return refuse(
            Status::RRS_MOTION_TYPE_NOT_SUPPORTED,
            "Linear and circular motion to joint values need joints that carry the position of the tool; "
            "this machine has none.");
    }
    programmed_.motion_type = type;
    via_.reset();
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SelectDominantInterpolation(rrs::Dominance dominance) {
    if (!initialized_) return not_initialized();
    const int number = static_cast<int>(dominance);
    if (number < 0 || number > 2) {
        return refuse(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no dominance {}; 0 is automatic, 1 position, 2 orientation.", number));
    }
    programmed_.dominance = dominance;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SelectFlybyMode(bool on) {
    if (!initialized_) return not_initialized();
    if (on && !model_)
        return refuse(Status::RRS_MODE_NOT_SUPPORTED,
                      "The default planner stops at each target; it has no fly-by.");
    programmed_.path_mode = on ? rrs::PathMode::continuous : rrs::PathMode::exact_stop;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SetPathMode(rrs::PathMode mode, double tolerance_mm, double merge_tolerance_mm) {
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
    const bool stops = mode == rrs::PathMode::exact_path && setup_.controller.exact_path_stops;
    programmed_.path_mode = stops ? rrs::PathMode::exact_stop : mode;
    programmed_.tolerance_mm = tolerance_mm;
    programmed_.merge_tolerance_mm = merge_tolerance_mm;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SetRapid(bool on) {
    if (!initialized_) return not_initialized();
    programmed_.rapid = on;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SetInterpolationTime(double interpolation_s) {
    if (!initialized_) return not_initialized();
    if (!(interpolation_s >= kLeastTime_s && interpolation_s <= kLongest_s)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The interpolation time is from {} to {} s; {} was asked for.",
                                  kLeastTime_s, kLongest_s, interpolation_s));
    }
    programmed_.interpolation_s = interpolation_s;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SetJointSpeeds(std::span<const int> joints, std::span<const double> speeds) {
    return set_joint_values(programmed_.joint_speeds, joints, speeds, "speed");
}

Status DefaultPlanner::SetJointAccelerations(std::span<const int> joints,
                                             std::span<const double> accelerations) {
    return set_joint_values(programmed_.joint_accelerations, joints, accelerations, "acceleration");
}

Status DefaultPlanner::SetJointJerks(std::span<const int> joints, std::span<const double> jerks) {
    return set_joint_values(programmed_.joint_jerks, joints, jerks, "jerk");
}

Status DefaultPlanner::SetRampMode(rrs::RampMode mode) {
    if (!initialized_) return not_initialized();
    const int number = static_cast<int>(mode);
    if (number < 0 || number > 3) {
        return refuse(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no ramp mode {}; 0 is the machine's own, 1 linear, 2 S-curve, 3 infinite.",
                        number));
    }
    if (mode != rrs::RampMode::machine && setup_.controller.planner == rrs::PlannerKind::linuxcnc)
        return own_ramps();
    programmed_.ramps.mode = mode;
    put_in_force(programmed_.ramps, machine_, setup_);
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SetJointRampLimits(rrs::RampLimit limit, std::span<const int> joints,
                                          std::span<const double> values) {
    if (!initialized_) return not_initialized();
    const int number = static_cast<int>(limit);
    if (number < 0 || number > 2) {
        return refuse(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("There is no limit {}; 0 is acceleration, 1 deceleration, 2 jerk.", number));
    }
    if (setup_.controller.planner == rrs::PlannerKind::linuxcnc) return own_ramps();
    constexpr std::string_view kNames[] = {"acceleration", "deceleration", "jerk"};
    const Status status = set_joint_values(programmed_.ramps.of(limit), joints, values, kNames[number]);
    if (status == Status::RRS_SUCCESS) put_in_force(programmed_.ramps, machine_, setup_);
    return status;
}

Status DefaultPlanner::own_ramps() {
    return refuse(Status::RRS_MODE_NOT_SUPPORTED,
                  "This controller has ramps of its own, which a program cannot change.");
}

Status DefaultPlanner::SetCartesianPositionSpeed(double speed_mm_s) {
    return set_positive(programmed_.position_speed_mm_s, speed_mm_s, "speed");
}

Status DefaultPlanner::SetCartesianOrientationSpeed(double speed_rad_s) {
    return set_positive(programmed_.orientation_speed_rad_s, speed_rad_s, "orientation speed");
}

Status DefaultPlanner::SetCartesianPositionAcceleration(double acceleration_mm_s2) {
    return set_positive(programmed_.position_acceleration_mm_s2, acceleration_mm_s2, "acceleration");
}

Status DefaultPlanner::SetCartesianOrientationAcceleration(double acceleration_rad_s2) {
    return set_positive(programmed_.orientation_acceleration_rad_s2, acceleration_rad_s2,
                        "orientation acceleration");
}

Status DefaultPlanner::SetOverrideSpeed(double percent) {
    return set_percent(programmed_.speed_override, percent, "speed");
}

Status DefaultPlanner::SetOverrideAcceleration(double percent) {
    return set_percent(programmed_.acceleration_override, percent, "acceleration");
}

Status DefaultPlanner::SetMotionTime(double motion_s) {
    if (!initialized_) return not_initialized();
    if (!(motion_s >= kLeastTime_s && motion_s <= kLongest_s)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("A motion time is from {} to {} s; {} was asked for.", kLeastTime_s,
                                  kLongest_s, motion_s));
    }
    programmed_.motion_time_s = motion_s;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::SetRestParameter(double rest_s) {
    if (!initialized_) return not_initialized();
    if (!(rest_s >= 0 && rest_s <= kLongest_s)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("A rest takes from 0 to {} s; {} was asked for.", kLongest_s, rest_s));
    }
    programmed_.rest_s = rest_s;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::set_positive(double& value, double wanted, std::string_view what) {
    if (!initialized_) return not_initialized();
    if (!(wanted > 0)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The {} must be greater than 0; {} was asked for.", what, wanted));
    }
    value = wanted;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::set_percent(double& factor, double percent, std::string_view what) {
    if (!initialized_) return not_initialized();
    if (!(percent > 0 && percent <= kMaxPercent)) {
        return refuse(Status::RRS_INVALID_PARAMETER,
                      fmt::format("The {} override is above 0 and at most {} percent; {} was asked for.",
                                  what, kMaxPercent, percent));
    }
    factor = percent / 100;
    return Status::RRS_SUCCESS;
}

Status DefaultPlanner::set_joint_values(rrs::JointPos& values, std::span<const int> joints,
                                        std::span<const double> wanted, std::string_view what) {
    if (!initialized_) return not_initialized();
    const std::size_t count = joints.empty() ? setup_.joints.size() : joints.size();
    if (wanted.size() != count) {
        return refuse(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("{} values were given for the {} of {} joints.", wanted.size(), what, count));
    }
    rrs::JointPos changed = values;
    for (std::size_t i = 0; i < count; ++i) {
        const int joint = joints.empty() ? static_cast<int>(i) : joints[i];
        if (joint < 0 || joint >= setup_.joint_count()) {
            return refuse(
                Status::RRS_INVALID_PARAMETER,
                fmt::format("There is no joint {}; joints are 0 to {}.", joint, setup_.joint_count() - 1));
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

}  // namespace gsim::motion
