#pragma once

#include <limits>

namespace gsim::motion {

/// Limits of a motion along its path, each > 0 and possibly infinite (mm or rad, s). An infinite jerk gives
/// trapezoids; speeds jump if the acceleration is also infinite.
struct LawLimits {
    double max_speed = std::numeric_limits<double>::infinity();
    double acceleration = std::numeric_limits<double>::infinity();
    double deceleration = std::numeric_limits<double>::infinity();
    double jerk = std::numeric_limits<double>::infinity();
};

/// A motion as two ramps (see ramp.h) with a cruise between them.
struct SpeedShape {
    double first_change = 0;   ///< Speed change of the first ramp; negative if it brakes.
    double second_change = 0;  ///< By the second ramp, likewise.
    double cruise_speed = 0;
    double cruise_length = 0;  ///< Not negative.
};

/// Returns the fastest motion over `length` > 0 from start_speed to end_speed, both >= 0, with acceleration 0
/// at both ends if the jerk is finite. It brakes first if the start is too fast for max_speed. Speeds above
/// max_speed are kept to what start_speed, end_speed and the length require.
///
/// The result is the ramp from start_speed to end_speed if the length is less than that needs. It is then
/// longer than `length`. Shapes without cruise meet the length within 1e-12 of it, in most cases within some
/// roundings.
SpeedShape fastest_shape(double length, double start_speed, double end_speed, const LawLimits& limits);

}  // namespace gsim::motion
