#pragma once

#include "motion/profile/time_law.h"

namespace gsim::motion {

/// The first `t_s` of a law.
TimeLaw law_until(const TimeLaw& law, double t_s);

/// What a law does behind its first `t_s`, from 0 again.
TimeLaw law_from(const TimeLaw& law, double t_s);

/// A law, and then a rest until `duration_s`.
TimeLaw law_and_rest(const TimeLaw& law, double duration_s);

/// Slows down from the state of a law at `t_s`, at once and as hard as the limits allow, to rest where what
/// is left of the law is long enough for that; otherwise to its end, with a speed there as low as can be,
/// and never above the one that the law has there.
/// With a finite jerk an acceleration under way ends first; a deceleration under way goes on as it was
/// planned.
TimeLaw braking_law(const TimeLaw& law, double t_s, const LawLimits& limits);

/// The same over a whole way of `length` that begins at `start_speed` and was planned to end at `end_speed`.
TimeLaw braking_law(double length, double start_speed, double end_speed, const LawLimits& limits);

}  // namespace gsim::motion
