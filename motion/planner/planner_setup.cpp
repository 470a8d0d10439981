#include "motion/planner/planner_setup.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "motion/path/orientation_path.h"

namespace gsim::motion {

namespace {

using SetupError = std::optional<std::string>;

SetupError check_positive(const std::string& what, double value) {
    if (value > 0) return std::nullopt;
    return fmt::format("{} is {}; it must be greater than 0 (infinity for no limit).", what, value);
}

SetupError check_not_negative(const std::string& what, double value) {
    if (value >= 0 && std::isfinite(value)) return std::nullopt;
    return fmt::format("{} is {}; it must be 0 or greater.", what, value);
}

SetupError check_joint(int index, const JointSetup& joint) {
    if (!(joint.min <= joint.max)) {
        return fmt::format("The range of joint {} is from {} to {}; min must not be above max.", index,
                           joint.min, joint.max);
    }
    if (auto error = check_positive(fmt::format("max_speed of joint {}", index), joint.max_speed))
        return error;
    if (auto error =
            check_positive(fmt::format("max_acceleration of joint {}", index), joint.max_acceleration))
        return error;
    if (auto error = check_positive(fmt::format("max_deceleration of joint {}", index), joint.deceleration()))
        return error;
    if (auto error = check_positive(fmt::format("max_jerk of joint {}", index), joint.max_jerk)) return error;
    if (auto error = check_positive(fmt::format("max_speed_step of joint {}", index), joint.max_speed_step))
        return error;
    return check_not_negative(fmt::format("step of joint {}", index), joint.step);
}

SetupError check_path(const PathLimits& path) {
    if (auto error = check_positive("max_feed_mm_s of the path", path.max_feed_mm_s)) return error;
    if (auto error = check_positive("max_rapid_mm_s of the path", path.max_rapid_mm_s)) return error;
    if (auto error = check_positive("max_acceleration_mm_s2 of the path", path.max_acceleration_mm_s2))
        return error;
    if (auto error =
            check_positive("max_rapid_acceleration_mm_s2 of the path", path.max_rapid_acceleration_mm_s2))
        return error;
    return check_positive("max_jerk_mm_s3 of the path", path.max_jerk_mm_s3);
}

SetupError check_corners(const rrs::ControllerRules& controller) {
    if (controller.blocks.look_ahead < 1) {
        return fmt::format("look_ahead_blocks of the controller is {}; it must be at least 1.",
                           controller.blocks.look_ahead);
    }
    const double share = controller.ramps.centripetal_share;
    if (!(share > 0)) {
        return fmt::format(
            "centripetal_share of the controller is {}; it must be greater than 0 (infinity: curves do not "
            "slow the motion).",
            share);
    }
    const double continuous = controller.ramps.continuous_acceleration_share;
    if (continuous > 0 && continuous <= 1) return std::nullopt;
    return fmt::format(
        "continuous_acceleration_share of the controller is {}; it must be greater than 0 and at most 1.",
        continuous);
}

SetupError check_controller(const rrs::ControllerRules& controller) {
    if (auto error = check_corners(controller)) return error;
    if (auto error = check_positive("speed_step_s of the controller", controller.corners.speed_step_s))
        return error;
    for (const auto& [name, value] :
         {std::pair{"tcp_tolerance_mm", controller.coordination.tcp_tolerance_mm},
          std::pair{"in_position_mm", controller.position_loop.in_position_mm},
          std::pair{"in_position_deg", controller.position_loop.in_position_deg}}) {
        if (auto error = check_positive(fmt::format("{} of the controller", name), value)) return error;
    }
    const std::pair<const char*, double> not_negative[] = {
        {"junction_deviation_mm", controller.corners.junction_deviation_mm},
        {"arc_chord_tolerance_mm", controller.curves.arc_chord_tolerance_mm},
        {"arc_resolution_mm", controller.klipper.arc_resolution_mm},
        {"square_corner_velocity_mm_s", controller.klipper.square_corner_velocity_mm_s},
        {"minimum_cruise_ratio", controller.klipper.minimum_cruise_ratio},
        {"min_feed_mm_min", controller.blocks.min_feed_mm_min},
        {"blend_tolerance_mm", controller.corners.blend_tolerance_mm},
        {"blend_tolerance_deg", controller.corners.blend_tolerance_deg},
        {"settle_s", controller.position_loop.settle_s},
        {"position_gain_1_s", controller.position_loop.gain_1_s},
        {"standstill_s", controller.standstill.dwell_s},
        {"dwell_step_s", controller.standstill.dwell_step_s},
        {"servo_period_s", controller.position_loop.servo_period_s},
    };
    for (const auto& [name, value] : not_negative) {
        if (auto error = check_not_negative(fmt::format("{} of the controller", name), value)) return error;
    }
    if (controller.klipper.minimum_cruise_ratio >= 1) {
        return fmt::format("minimum_cruise_ratio of the controller is {}; it must be less than 1.",
                           controller.klipper.minimum_cruise_ratio);
    }
    return std::nullopt;
}

SetupError check_position_joints(const PlannerSetup& setup) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[axis];
        if (joint == -1) continue;
        if (joint < -1 || joint >= setup.joint_count()) {
            return fmt::format("Position joint {} does not exist; joints are 0 to {}.", joint,
                               setup.joint_count() - 1);
        }
        if (setup.joints[static_cast<std::size_t>(joint)].kind != rrs::JointKind::prismatic) {
            return fmt::format("Position joint {} is revolute; it must be prismatic.", joint);
        }
        if (std::count(setup.position_joints.begin(), setup.position_joints.end(), joint) > 1) {
            return fmt::format("Joint {} is used for more than one of x, y, z.", joint);
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> PlannerSetup::validate() const {
    if (joints.empty() || joints.size() > static_cast<std::size_t>(rrs::kMaxJoints)) {
        return fmt::format("There are {} joints; a planner accepts 1 to {}.", joints.size(), rrs::kMaxJoints);
    }
    for (int joint = 0; joint < joint_count(); ++joint) {
        if (auto error = check_joint(joint, joints[static_cast<std::size_t>(joint)])) return error;
    }
    if (auto error = check_path(path)) return error;
    if (auto error = check_controller(controller)) return error;
    if (auto error = check_position_joints(*this)) return error;
    if (!kinematics) return "The kinematics are missing.";
    if (kinematics->joint_count() != joint_count()) {
        return fmt::format("The kinematics have {} joints but the planner has {}.", kinematics->joint_count(),
                           joint_count());
    }
    if (!controller.coordination.interpolated_rapids && !controller.capabilities().plans_uncoordinated_joints)
        return "Rapids that are not interpolated need the planner that stops at each target.";
    if (!controller.coordination.interpolated_rapids && std::isfinite(path.max_rapid_mm_s))
        return "max_rapid_mm_s of the path is not possible if rapids are not interpolated.";
    if (controller.coordination.orientation == rrs::OrientationRule::great_circle) {
        if (auto error = find_great_circle_error(*this)) return error;
    }
    if (auto error = check_not_negative("arc_tolerance_mm", arc_tolerance_mm)) return error;
    if (queue_capacity < 2)
        return fmt::format("queue_capacity is {}; it must be at least 2.", queue_capacity);
    return std::nullopt;
}

JointRole PlannerSetup::role(int joint) const {
    if (joints[static_cast<std::size_t>(joint)].kind == rrs::JointKind::revolute) return JointRole::rotary;
    const bool carries =
        std::find(position_joints.begin(), position_joints.end(), joint) != position_joints.end();
    return carries ? JointRole::position : JointRole::secondary;
}

}  // namespace gsim::motion
