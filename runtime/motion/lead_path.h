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

    void limit_speed(double speed) { max_speed = speed < max_speed ? speed : max_speed; }
    void limit_acceleration(double acceleration) {
        max_acceleration = acceleration < max_acceleration ? acceleration : max_acceleration;
    }
};

/// Sets the time of a move and writes the laws into the segment: the duration is the longest of the lead's,
/// the followers' and `least_duration_s`, and lead and followers all take that long. RRS_ZERO_SPEED where
/// nothing at all limits the speed, RRS_INVALID_PARAMETER where a length or the time is beyond all numbers.
Planned set_timing(Segment& segment, const LeadPath& lead, const Followers* followers,
                   double least_duration_s);

}  // namespace gsim::motion
