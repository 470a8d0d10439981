#pragma once

#include <algorithm>

#include "motion/planner/plan_error.h"
#include "motion/segment/followers.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

/// Longest time of a move or dwell; it keeps the clock at useful numbers.
inline constexpr double kMaxDuration_s = 1e12;

/// Leading path of a move and the limits of the speed along it (mm or rad, s).
struct MasterPath {
    double length = 0;
    LawLimits limits = {};
    LimitCause speed_limit = {};         ///< Cause of limits.max_speed,
    LimitCause acceleration_limit = {};  ///< limits.acceleration
    LimitCause jerk_limit = {};          ///< and limits.jerk.

    void limit_speed(double speed, LimitCause by) {
        if (speed >= limits.max_speed) return;
        limits.max_speed = speed;
        speed_limit = by;
    }
    void limit_acceleration(double acceleration, LimitCause by) {
        if (acceleration >= limits.acceleration) return;
        limits.acceleration = acceleration;
        acceleration_limit = by;
    }
    void limit_deceleration(double deceleration) {
        limits.deceleration = std::min(limits.deceleration, deceleration);
    }
    void limit_jerk(double jerk, LimitCause by) {
        if (jerk >= limits.jerk) return;
        limits.jerk = jerk;
        jerk_limit = by;
    }
    /// Applies the limits of a joint that moves by `share` of the path.
    void limit_by_joint(int joint, const LawLimits& joint_limits, double share) {
        const auto index = static_cast<std::int8_t>(joint);
        limit_speed(joint_limits.max_speed / share, {LimitKind::joint_speed, index});
        limit_acceleration(joint_limits.acceleration / share, {LimitKind::acceleration, index});
        limit_deceleration(joint_limits.deceleration / share);
        limit_jerk(joint_limits.jerk / share, {LimitKind::jerk, index});
    }
};

/// Applies the programmed speed and acceleration of the tool, and the path's limits of them.
void limit_by_path(const MoveRules& rules, MasterPath& master);

/// Sets the time of a move, and writes the laws and the limiting cause into the segment. The duration is the
/// longest of the leading law's, the followers' and `min_duration_s`, and all of these laws take that long.
/// Errors: RRS_ZERO_SPEED if no limit applies to the speed, RRS_INVALID_PARAMETER if a length or the time is
/// too large.
PlanResult set_timing(Segment& segment, const MasterPath& master, const Followers* followers,
                      double min_duration_s);

/// Sets the time of a linear or circular move with the joints outside its path. These move in proportion to
/// the leading law, which also keeps their limits, or as followers, as the controller does. `role` is that of
/// the master joints.
PlanResult set_timing_with_other_joints(const PlannerSetup& setup, const MoveRules& rules,
                                        const JointChanges& changes, JointRole role, MasterPath master,
                                        Segment& segment);

}  // namespace gsim::motion
