#include "motion/profile/s_curve.h"

#include <algorithm>
#include <cmath>

#include "motion/profile/quadratic.h"
#include "motion/profile/ramp.h"

namespace gsim::motion {

namespace {

// Ratio up to which a length counts as that of the direct ramp: a smaller excess is the caller's rounding,
// not a request to speed up.
constexpr double kRoundingFactor = 1 + 1e-12;
constexpr int kMaxRootSteps = 60;

// One end of a motion: the speed there, and the limit of the ramp between it and the peak.
struct RampEnd {
    double speed;
    double acceleration;
};

// Fast end and slow end; the order in time does not matter for lengths.
struct RampEnds {
    RampEnd fast;
    RampEnd slow;
    double jerk;

    double gap() const { return fast.speed - slow.speed; }
    double direct_length() const { return ramp_length_by(slow.speed, gap(), slow.acceleration, jerk); }
    /// Returns the length of both ramps, if the peak is `excess` above the fast end.
    double length(double excess) const {
        return ramp_length_by(fast.speed, excess, fast.acceleration, jerk) +
               ramp_length_by(slow.speed, gap() + excess, slow.acceleration, jerk);
    }
};

double trapezoid_excess(double length, const RampEnds& ends) {
    const double slowness = 1 / ends.fast.acceleration + 1 / ends.slow.acceleration;
    return positive_root(2 * ends.fast.speed, 2 * (length - ends.direct_length()) / slowness);
}

// Each formula holds in the range of peaks for which its ramps have the assumed phases. The formulas are
// tried from low peaks to high ones.
double rest_to_rest_peak(double length, double acceleration, double deceleration, double jerk) {
    const auto [low, high] = std::minmax(acceleration, deceleration);
    const double short_root = std::cbrt(length * std::sqrt(jerk) / 2);
    const double short_peak = short_root * short_root;
    if (!(short_peak > low * low / jerk)) return short_peak;
    // One ramp holds its acceleration: the length is (x (x + low / sqrt(jerk)))^2 / (2 low) with x^2 = peak.
    const double one_root = positive_root(low / std::sqrt(jerk), std::sqrt(2 * low * length));
    const double one_peak = one_root * one_root;
    if (!(one_peak > high * high / jerk)) return one_peak;
    const double slowness = 1 / low + 1 / high;
    return positive_root((low + high) / jerk / slowness, 2 * length / slowness);
}

struct LengthAndSlope {
    double length;
    double slope;
};

// Returns the length of the ramp between an end and a peak x^2 above the fast end, and its derivative by x.
LengthAndSlope length_at(double x, double gap, const RampEnd& end, double jerk) {
    const double change = gap + x * x;
    const RampPhases ramp = ramp_phases(change, end.acceleration, jerk);
    const double mean_speed = end.speed + change / 2;
    // The time of a ramp grows with its change by 1 / (highest acceleration), for any of its phases.
    return {mean_speed * ramp.duration_s(), x * ramp.duration_s() + 2 * mean_speed * (x / ramp.acceleration)};
}

// Each ramp alone must fit, which bounds x from above.
double highest_root(double length, const RampEnds& ends) {
    const double fast_end_bound = std::sqrt(
        ramp_gain(length - ends.direct_length(), ends.fast.speed, ends.fast.acceleration, ends.jerk));
    const double slow_end_bound =
        ramp_gain(length, ends.slow.speed, ends.slow.acceleration, ends.jerk) - ends.gap();
    return slow_end_bound > 0 ? std::min(fast_end_bound, std::sqrt(slow_end_bound)) : fast_end_bound;
}

// Newton's method finds x = sqrt(excess). The length is convex and increasing in x, because each ramp's
// length is a polynomial with positive coefficients in x or in sqrt(gap + x^2), joined with a continuous
// slope. So the steps come down from above and never pass the root: the first that does not come down is
// rounding.
double s_curve_excess(double length, const RampEnds& ends) {
    double x = highest_root(length, ends);
    for (int i = 0; i < kMaxRootSteps && x > 0; ++i) {
        const LengthAndSlope fast = length_at(x, 0, ends.fast, ends.jerk);
        const LengthAndSlope slow = length_at(x, ends.gap(), ends.slow, ends.jerk);
        const double next = x - (fast.length + slow.length - length) / (fast.slope + slow.slope);
        if (!(next > 0) || (i > 0 && !(next < x))) break;
        x = next;
    }
    return x * x;
}

// Returns how far above the fast end the speed gets without a cap.
double excess(double length, const RampEnds& ends) {
    if (std::isinf(ends.jerk)) return trapezoid_excess(length, ends);
    if (ends.fast.speed > 0) return s_curve_excess(length, ends);
    return rest_to_rest_peak(length, ends.fast.acceleration, ends.slow.acceleration, ends.jerk);
}

// Ramps up to a peak of at most `cap` and down again.
SpeedShape peaked_shape(double length, double start, double end, double cap, const LawLimits& limits) {
    const RampEnd first{start, limits.acceleration};
    const RampEnd last{end, limits.deceleration};
    const bool speeds_up = start <= end;
    const RampEnds ends{speeds_up ? last : first, speeds_up ? first : last, limits.jerk};
    double above = 0;
    double cruise_length = 0;
    if (length > ends.direct_length() * kRoundingFactor) {
        const double headroom = cap - ends.fast.speed;
        const double ramp_length = std::isfinite(headroom) ? ends.length(headroom) : length;
        cruise_length = std::max(length - ramp_length, 0.0);
        above = cruise_length > 0 ? headroom : std::min(excess(length, ends), headroom);
    }
    const double slow_end_change = ends.gap() + above;
    return {speeds_up ? slow_end_change : above, speeds_up ? -above : -slow_end_change,
            ends.fast.speed + above, cruise_length};
}

// Returns how far the first of two braking ramps drops. The length is too short to brake to the cap and again
// to the end, but longer than braking in one. Uses bisection for sqrt(drop), because lengths are smooth in
// it.
double first_speed_drop(double length, double start, double end, double max_drop, const LawLimits& limits) {
    const auto braking_length = [&](double drop) {
        return ramp_length_by(start - drop, drop, limits.deceleration, limits.jerk) +
               ramp_length_by(end, start - end - drop, limits.deceleration, limits.jerk);
    };
    double low = 0;
    double high = std::sqrt(max_drop);
    for (int i = 0; i < kMaxRootSteps; ++i) {
        const double middle = (low + high) / 2;
        (braking_length(middle * middle) < length ? low : high) = middle;
    }
    return high * high;
}

// Handles a start above the cap: down to the cap, along it, and down to the end.
SpeedShape braking_shape(double length, double start, double end, double cap, const LawLimits& limits) {
    const double drop = start - cap;
    const double remainder = length - ramp_length_by(cap, drop, limits.deceleration, limits.jerk) -
                             ramp_length_by(end, cap - end, limits.deceleration, limits.jerk);
    if (remainder >= 0) return {-drop, end - cap, cap, remainder};
    const double direct = ramp_length_by(end, start - end, limits.deceleration, limits.jerk);
    if (!(length > direct * kRoundingFactor)) return {0, end - start, start, 0};
    const double part = first_speed_drop(length, start, end, drop, limits);
    return {-part, end - start + part, start - part, 0};
}

}  // namespace

SpeedShape fastest_shape(double length, double start_speed, double end_speed, const LawLimits& limits) {
    const double cap = std::max(limits.max_speed, end_speed);
    if (start_speed > cap) return braking_shape(length, start_speed, end_speed, cap, limits);
    return peaked_shape(length, start_speed, end_speed, cap, limits);
}

}  // namespace gsim::motion
