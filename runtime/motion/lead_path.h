#pragma once

#include "runtime/motion/followers.h"
#include "runtime/motion/plan_error.h"
#include "runtime/motion/segment.h"

namespace gsim::motion {

/// No move or rest takes longer than this; it keeps the clock a number worth having.
inline constexpr double kLongest_s = 1e12;

/// The path that leads a move and what limits the speed along it (mm or rad, s).
struct LeadPath {
    double length = 0;
    double max_speed = kUnlimited;
    double max_acceleration = kUnlimited;
    LimitedBy speed_limit = {};         ///< What max_speed is
    LimitedBy acceleration_limit = {};  ///< and max_acceleration.

    void limit_speed(double speed, LimitedBy by) {
        if (speed >= max_speed) return;
        max_speed = speed;
        speed_limit = by;
    }
    void limit_acceleration(double acceleration, LimitedBy by) {
        if (acceleration >= max_acceleration) return;
        max_acceleration = acceleration;
        acceleration_limit = by;
    }
    /// The limits of a joint that goes by `share` of the way.
    void limit_by_joint(int joint, const JointSetup& limits, double share) {
        const auto index = static_cast<std::int8_t>(joint);
        limit_speed(limits.max_speed / share, {LimitKind::joint_speed, index});
        limit_acceleration(limits.max_acceleration / share, {LimitKind::acceleration, index});
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

}  // namespace gsim::motion
