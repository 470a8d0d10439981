#include "motion/planner/move_parameters.h"

#include <algorithm>

#include <fmt/format.h>

#include "motion/path/master_path.h"
#include "motion/segment/followers.h"

namespace gsim::motion {

using rrs::Status;

namespace {

constexpr double kMinTime_s = 1e-6;

}  // namespace

JointParameters::JointParameters(int joint_count)
    : speeds(rrs::JointPos::Constant(joint_count, kUnlimited)), accelerations(speeds), jerks(speeds) {}

MoveRules MoveParameters::rules(const PathLimits& path) const {
    MoveRules rules{.dominance = dominance, .min_duration_s = motion_time_s};
    if (rapid) {
        rules.max_path_speed_mm_s = path.max_rapid_mm_s;
        if (ramp_mode() != rrs::RampMode::infinite)
            rules.path_acceleration_mm_s2 = path.max_rapid_acceleration_mm_s2;
        return rules;
    }
    rules.max_path_speed_mm_s = path.max_feed_mm_s;
    rules.follows_spindle = follows_spindle;
    if (ramp_mode() != rrs::RampMode::infinite) {
        rules.path_acceleration_mm_s2 =
            std::min(position_acceleration_mm_s2 * acceleration_override, path.max_acceleration_mm_s2);
        rules.orientation_acceleration_rad_s2 = orientation_acceleration_rad_s2 * acceleration_override;
    }
    if (motion_time_s > 0) return rules;
    rules.programmed_speed_mm_s = position_speed_mm_s * speed_override;
    rules.orientation_speed_rad_s = orientation_speed_rad_s * speed_override;
    return rules;
}

LawLimits MoveParameters::joint_limits(const PlannerSetup& setup, int joint, double speed_share) const {
    LawLimits limits = law_limits(setup, joint);
    const double limit = limits.max_speed;
    if (joints && motion_time_s <= 0)
        limits.max_speed = std::min(joints->speeds[joint] * speed_override, limit);
    limits.max_speed = std::min(limits.max_speed * speed_share, limit);
    if (!joints || ramp_mode() == rrs::RampMode::infinite) return limits;
    const double acceleration = joints->accelerations[joint] * acceleration_override;
    limits.acceleration = std::min(acceleration, limits.acceleration);
    limits.deceleration = std::min(acceleration, limits.deceleration);
    if (ramp_mode() != rrs::RampMode::linear) limits.jerk = std::min(joints->jerks[joint], limits.jerk);
    return limits;
}

PlanResult check_positive(double value, std::string_view what) {
    if (value > 0) return {};
    return make_plan_error(Status::RRS_INVALID_PARAMETER,
                           fmt::format("The {} must be greater than 0, not {}.", what, value));
}

PlanResult check_motion_time(double motion_s) {
    if (motion_s >= kMinTime_s && motion_s <= kMaxDuration_s) return {};
    return make_plan_error(
        Status::RRS_INVALID_PARAMETER,
        fmt::format("A motion time must be from {} to {} s, not {}.", kMinTime_s, kMaxDuration_s, motion_s));
}

}  // namespace gsim::motion
