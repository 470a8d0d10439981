#pragma once

#include "motion/profile/time_law.h"

namespace gsim::motion {

/// The least time of a motion over `length` >= 0 from rest to rest.
double fastest_rest_s(double length, const LawLimits& limits);

/// The motion over `length` from rest to rest in `duration_s`: the fastest one where that is `fastest_s`, the
/// time of fastest_rest_s(), otherwise one with the same ramps and a lower cruise speed.
TimeLaw rest_law(double length, const LawLimits& limits, double fastest_s, double duration_s);

}  // namespace gsim::motion
