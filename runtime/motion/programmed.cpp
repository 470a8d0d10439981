#include "runtime/motion/programmed.h"

#include <algorithm>

namespace gsim::motion {

Programmed::Programmed(int joint_count)
    : joint_speeds(rrs::JointPos::Constant(joint_count, kUnlimited)),
      joint_accelerations(rrs::JointPos::Constant(joint_count, kUnlimited)) {}

MoveRules Programmed::rules(const PathLimits& path) const {
    MoveRules rules{.dominance = dominance, .least_duration_s = motion_time_s};
    if (rapid) {
        rules.max_path_speed_mm_s = path.max_rapid_mm_s;
        return rules;
    }
    rules.max_path_speed_mm_s = path.max_feed_mm_s;
    rules.path_acceleration_mm_s2 =
        std::min(position_acceleration_mm_s2 * acceleration_override, path.max_acceleration_mm_s2);
    rules.orientation_acceleration_rad_s2 = orientation_acceleration_rad_s2 * acceleration_override;
    if (motion_time_s > 0) return rules;
    rules.programmed_speed_mm_s = position_speed_mm_s * speed_override;
    rules.orientation_speed_rad_s = orientation_speed_rad_s * speed_override;
    return rules;
}

double Programmed::joint_speed(const JointSetup& limits, int joint) const {
    if (motion_time_s > 0) return limits.max_speed;
    return std::min(joint_speeds[joint] * speed_override, limits.max_speed);
}

double Programmed::joint_acceleration(const JointSetup& limits, int joint) const {
    return std::min(joint_accelerations[joint] * acceleration_override, limits.max_acceleration);
}

}  // namespace gsim::motion
