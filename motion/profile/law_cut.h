#pragma once

#include "motion/profile/time_law.h"

namespace gsim::motion {

/// Returns the first `t_s` of a law.
TimeLaw law_until(const TimeLaw& law, double t_s);

/// Returns the law from `t_s` on, which begins at 0 again.
TimeLaw law_from(const TimeLaw& law, double t_s);

/// Returns a law, followed by a standstill until `duration_s`.
TimeLaw extend_with_standstill(const TimeLaw& law, double duration_s);

/// Returns the law that slows down from the state of a law at `t_s`, at once and as hard as the limits allow.
/// It ends at standstill if the remainder of the law is long enough. Otherwise it ends at the law's end with
/// a speed as low as possible, and never above the one that the law has there. An active acceleration ends
/// first with a finite jerk; an active deceleration continues as planned.
TimeLaw braking_law(const TimeLaw& law, double t_s, const LawLimits& limits);

/// Returns the same over a full path of `length` that begins at `start_speed` and was planned to end at
/// `end_speed`.
TimeLaw braking_law(double length, double start_speed, double end_speed, const LawLimits& limits);

}  // namespace gsim::motion
