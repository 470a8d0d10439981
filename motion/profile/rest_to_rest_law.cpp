#include "motion/profile/rest_to_rest_law.h"

#include <cmath>

namespace gsim::motion {

namespace {

/// Straight ramps that are the same in both directions have shorter formulas.
bool is_trapezoid(const LawLimits& limits) {
    return std::isinf(limits.jerk) && limits.acceleration == limits.deceleration;
}

}  // namespace

double min_rest_to_rest_s(double length, const LawLimits& limits) {
    if (is_trapezoid(limits)) return TimeLaw::fastest_s(length, limits.max_speed, limits.acceleration);
    return TimeLaw::between(length, 0, 0, limits).duration_s();
}

TimeLaw rest_to_rest_law(double length, const LawLimits& limits, double fastest_s, double duration_s) {
    const bool fastest = duration_s <= fastest_s;
    if (is_trapezoid(limits)) {
        return fastest ? TimeLaw::fastest(length, limits.max_speed, limits.acceleration)
                       : TimeLaw::with_duration(length, duration_s, limits.acceleration, limits.max_speed);
    }
    return fastest ? TimeLaw::between(length, 0, 0, limits)
                   : TimeLaw::with_duration(length, duration_s, limits);
}

}  // namespace gsim::motion
