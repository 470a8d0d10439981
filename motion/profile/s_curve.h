#pragma once

#include <limits>

namespace gsim::motion {

/// Limits of a motion along its path, each > 0 and possibly infinite (mm or rad, s). An infinite jerk gives
/// trapezoids; where the acceleration is infinite, too, speeds jump.
struct LawLimits {
    double max_speed = std::numeric_limits<double>::infinity();
    double acceleration = std::numeric_limits<double>::infinity();
    double deceleration = std::numeric_limits<double>::infinity();
    double jerk = std::numeric_limits<double>::infinity();
};

/// A motion as two ramps (see ramp.h) with a cruise between them.
struct SpeedShape {
    double first_change = 0;   ///< Of the speed, by the first ramp; negative if it brakes.
    double second_change = 0;  ///< By the second ramp, likewise.
    double cruise_speed = 0;
    double cruise_length = 0;  ///< Not negative.
};

/// The fastest motion over `length` > 0 from start_speed to end_speed, both >= 0, with acceleration 0 at both
/// ends if the jerk is finite. Where the start is too fast for max_speed it brakes first. Speeds above
/// max_speed are kept to what start_speed, end_speed and the length ask for.
///
/// Where the length is less than the ramp from start_speed to end_speed needs, the result is that ramp, which
/// is then longer than `length`. Shapes without cruise meet the length within 1e-12 of it, in most cases
/// within some roundings.
SpeedShape fastest_shape(double length, double start_speed, double end_speed, const LawLimits& limits);

}  // namespace gsim::motion
