#pragma once

#include "motion/profile/time_law.h"

namespace gsim::motion {

/// Returns the least time of a motion over `length` >= 0 from standstill to standstill.
double min_rest_to_rest_s(double length, const LawLimits& limits);

/// Returns the motion over `length` from standstill to standstill in `duration_s`. It is the fastest one if
/// that is `fastest_s`, the time of min_rest_to_rest_s(), otherwise one with the same ramps and a lower
/// cruise speed.
TimeLaw rest_to_rest_law(double length, const LawLimits& limits, double fastest_s, double duration_s);

}  // namespace gsim::motion
