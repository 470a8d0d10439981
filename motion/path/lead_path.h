#pragma once

#include <algorithm>

#include "motion/planner/plan_error.h"
#include "motion/segment/followers.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

/// No move or rest takes longer than this; it keeps the clock a number worth having.
inline constexpr double kLongest_s = 1e12;

/// The path that leads a move and what limits the speed along it (mm or rad, s).
struct LeadPath {
    double length = 0;
    LawLimits limits = {};
    LimitedBy speed_limit = {};         ///< What limits.max_speed is,
    LimitedBy acceleration_limit = {};  ///< limits.acceleration
    LimitedBy jerk_limit = {};          ///< and limits.jerk.

    void limit_speed(double speed, LimitedBy by) {
        if (speed >= limits.max_speed) return;
        limits.max_speed = speed;
        speed_limit = by;
    }
    void limit_acceleration(double acceleration, LimitedBy by) {
        if (acceleration >= limits.acceleration) return;
        limits.acceleration = acceleration;
        acceleration_limit = by;
    }
    void limit_deceleration(double deceleration) {
        limits.deceleration = std::min(limits.deceleration, deceleration);
    }
    void limit_jerk(double jerk, LimitedBy by) {
        if (jerk >= limits.jerk) return;
        limits.jerk = jerk;
        jerk_limit = by;
    }
    /// The limits of a joint that goes by `share` of the way.
    void limit_by_joint(int joint, const LawLimits& of_joint, double share) {
        const auto index = static_cast<std::int8_t>(joint);
        limit_speed(of_joint.max_speed / share, {LimitKind::joint_speed, index});
        limit_acceleration(of_joint.acceleration / share, {LimitKind::acceleration, index});
        limit_deceleration(of_joint.deceleration / share);
        limit_jerk(of_joint.jerk / share, {LimitKind::jerk, index});
    }
};

/// The programmed speed and acceleration of the tool, and the path's limits of them.
void limit_by_path(const MoveRules& rules, LeadPath& lead);

/// Sets the time of a move and writes the laws into the segment, and what limited it: the duration is the
/// longest of the lead's, the followers' and `least_duration_s`, and lead and followers all take that long.
/// RRS_ZERO_SPEED where nothing at all limits the speed, RRS_INVALID_PARAMETER where a length or the time is
/// beyond all numbers.
Planned set_timing(Segment& segment, const LeadPath& lead, const Followers* followers,
                   double least_duration_s);

/// The same of a linear or circular move with the joints beside its path: in proportion to the lead, which
/// keeps their limits, too, or followers, as the controller has it. `role` is that of the joints that lead.
Planned set_timing_with_beside(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes,
                               JointRole role, LeadPath lead, Segment& segment);

}  // namespace gsim::motion
