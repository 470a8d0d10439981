#include "motion/profile/ramp.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/profile/quadratic.h"

namespace gsim::motion {

namespace {

// Finds the root x = sqrt(gain) of x^3 + 2 from x = length sqrt(jerk), by Cardano. The root is cube - p /
// cube with p = 2 from / 3; this form of the difference has no cancellation.
double short_ramp_gain(double length, double from_speed, double jerk) {
    const double half = length * std::sqrt(jerk) / 2;
    const double p = 2 * from_speed / 3;
    const double cube = std::cbrt(half + std::sqrt(half * half + p * p * p));
    if (!(cube > 0)) return 0;
    const double other = p / cube;
    const double root = 2 * half / (cube * cube + p + other * other);
    return root * root;
}

}  // namespace

RampPhases ramp_phases(double change, double acceleration, double jerk) {
    const bool jumps = std::isinf(acceleration) && std::isinf(jerk);
    if (!(change > 0) || jumps) return {};
    if (std::isinf(jerk)) return {0, change / acceleration, acceleration};
    if (change <= acceleration * acceleration / jerk) {
        const double jerk_s = std::sqrt(change / jerk);
        return {jerk_s, 0, jerk_s * jerk};
    }
    const double jerk_s = acceleration / jerk;
    return {jerk_s, std::max(change / acceleration - jerk_s, 0.0), acceleration};
}

double ramp_length_by(double low_speed, double change, double acceleration, double jerk) {
    if (!(change > 0)) return 0;
    return (low_speed + change / 2) * ramp_phases(change, acceleration, jerk).duration_s();
}

double ramp_s(double from_speed, double to_speed, double acceleration, double jerk) {
    return ramp_phases(std::abs(to_speed - from_speed), acceleration, jerk).duration_s();
}

double ramp_length(double from_speed, double to_speed, double acceleration, double jerk) {
    const double change = std::abs(to_speed - from_speed);
    return ramp_length_by(std::min(from_speed, to_speed), change, acceleration, jerk);
}

double ramp_gain(double length, double from_speed, double acceleration, double jerk) {
    if (!(length > 0)) return 0;
    if (std::isinf(jerk)) return positive_root(2 * from_speed, 2 * acceleration * length);
    const double jerk_s = acceleration / jerk;
    const double short_gain = acceleration * jerk_s;  // the maximum without a phase of constant acceleration
    if (!(length > (2 * from_speed + short_gain) * jerk_s)) return short_ramp_gain(length, from_speed, jerk);
    return positive_root(2 * from_speed + short_gain, 2 * (acceleration * length - from_speed * short_gain));
}

double ramp_end_speed(double length, double from_speed, double acceleration, double jerk) {
    const double gain = ramp_gain(length, from_speed, acceleration, jerk);
    const double speed = from_speed + gain;
    // A small gain on a high speed may be rounded up by much of itself.
    if (!(speed - from_speed > gain)) return speed;
    return std::max(speed * (1 - std::numeric_limits<double>::epsilon()), from_speed);
}

// Ends of ramps fall with the start up to a certain start and grow from there. The end is three times the
// start at that start in a short ramp. The start is acceleration^2 / (2 jerk) in a ramp with constant
// acceleration. The lesser of both is the one that holds.
double reachable_speed(double length, double from_speed, double acceleration, double jerk) {
    if (std::isinf(jerk) || !(length > 0)) return ramp_end_speed(length, from_speed, acceleration, jerk);
    const double turn =
        std::min(acceleration * acceleration / (2 * jerk), std::cbrt(length * length * jerk / 32));
    return ramp_end_speed(length, std::max(from_speed, turn), acceleration, jerk);
}

}  // namespace gsim::motion
