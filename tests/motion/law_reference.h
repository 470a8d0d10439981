#pragma once

#include <algorithm>
#include <cmath>

#include "tests/motion/law_cases.h"

namespace gsim::motion {

// Times and lengths from first principles, in long double, and independent of the code under test.
using Real = long double;

inline Real time_of(Real change, Real acceleration, Real jerk) {
    if (change == 0) return 0;
    if (std::isinf(jerk)) return change / acceleration;
    const Real full = acceleration / jerk;
    return change <= full * acceleration ? 2 * std::sqrt(change / jerk) : change / acceleration + full;
}

struct Motion {
    Real length, time_s;
};

/// From the start to a peak and to the end, each by one ramp.
inline Motion through(Real peak, const LawCase& c) {
    const Real up_s = time_of(peak - c.start, c.limits.acceleration, c.limits.jerk);
    const Real down_s = time_of(peak - c.end, c.limits.deceleration, c.limits.jerk);
    return {(peak + c.start) / 2 * up_s + (peak + c.end) / 2 * down_s, up_s + down_s};
}

/// Returns the time between standstills below max_speed, solved for the time instead of the peak speed.
inline Real uncapped_time_s(Real length, Real low, Real high, Real jerk) {
    const Real slowness = 1 / low + 1 / high;
    if (std::isinf(jerk)) return std::sqrt(2 * length * slowness);
    const Real four_phases_s = 4 * std::cbrt(length / (2 * jerk));
    if (four_phases_s <= 4 * low / jerk) return four_phases_s;
    // The ramp of the higher limit is two phases of t with t (t + low / jerk) = sqrt(2 low length) / jerk.
    const Real half = low / jerk / 2;
    const Real t = std::sqrt(half * half + std::sqrt(2 * low * length) / jerk) - half;
    if (t <= high / jerk) return (t + low / jerk) * (t + low / jerk) * jerk / low;
    // T^2 - (low + high) / jerk T = 2 length slowness.
    const Real middle = (low + high) / jerk / 2;
    return middle + std::sqrt(middle * middle + 2 * length * slowness);
}

inline Real least_rest_to_rest_s(const LawCase& c) {
    const auto [low, high] = std::minmax(c.limits.acceleration, c.limits.deceleration);
    if (std::isfinite(c.limits.max_speed)) {
        const Motion ramps = through(c.limits.max_speed, c);
        if (ramps.length <= c.length) return ramps.time_s + (c.length - ramps.length) / c.limits.max_speed;
    } else if (std::isinf(c.limits.jerk) && std::isinf(low)) {
        return 0;
    }
    return uncapped_time_s(c.length, low, high, c.limits.jerk);
}

/// The peak by bisection: the length through a peak grows with it.
inline Real bisected_peak(const LawCase& c) {
    const Real fast = std::max(c.start, c.end);
    Real low = 0;
    Real high = 1e7;
    for (int i = 0; i < 100; ++i) {
        const Real middle = (low + high) / 2;
        (through(fast + middle, c).length < c.length ? low : high) = middle;
    }
    return std::min<Real>(fast + low, std::max<Real>(c.limits.max_speed, fast));
}

inline Real least_time_s(const LawCase& c) {
    const Real peak = bisected_peak(c);
    const Motion ramps = through(peak, c);
    return ramps.time_s + std::max<Real>(c.length - ramps.length, 0) / peak;
}

}  // namespace gsim::motion
