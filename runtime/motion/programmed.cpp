#include "runtime/motion/programmed.h"

#include <algorithm>

#include "runtime/motion/followers.h"

namespace gsim::motion {

Programmed::Programmed(int joint_count)
    : joint_speeds(rrs::JointPos::Constant(joint_count, kUnlimited)),
      joint_accelerations(joint_speeds),
      joint_jerks(joint_speeds),
      ramps(joint_count) {}

MoveRules Programmed::rules(const PathLimits& path) const {
    MoveRules rules{.dominance = dominance, .least_duration_s = motion_time_s};
    if (rapid) {
        rules.max_path_speed_mm_s = path.max_rapid_mm_s;
        return rules;
    }
    rules.max_path_speed_mm_s = path.max_feed_mm_s;
    rules.follows_spindle = follows_spindle;
    if (ramps.mode != rrs::RampMode::infinite) {
        rules.path_acceleration_mm_s2 =
            std::min(position_acceleration_mm_s2 * acceleration_override, path.max_acceleration_mm_s2);
        rules.orientation_acceleration_rad_s2 = orientation_acceleration_rad_s2 * acceleration_override;
    }
    if (motion_time_s > 0) return rules;
    rules.programmed_speed_mm_s = position_speed_mm_s * speed_override;
    rules.orientation_speed_rad_s = orientation_speed_rad_s * speed_override;
    return rules;
}

LawLimits Programmed::joint_limits(const PlannerSetup& setup, int joint, double speed_share) const {
    LawLimits limits = law_limits(setup, joint);
    const double limit = limits.max_speed;
    if (motion_time_s <= 0) limits.max_speed = std::min(joint_speeds[joint] * speed_override, limit);
    limits.max_speed = std::min(limits.max_speed * speed_share, limit);
    if (ramps.mode == rrs::RampMode::infinite) return limits;
    const double acceleration = joint_accelerations[joint] * acceleration_override;
    limits.acceleration = std::min(acceleration, limits.acceleration);
    limits.deceleration = std::min(acceleration, limits.deceleration);
    if (ramps.mode != rrs::RampMode::linear) limits.jerk = std::min(joint_jerks[joint], limits.jerk);
    return limits;
}

}  // namespace gsim::motion
