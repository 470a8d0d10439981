#pragma once

namespace gsim::motion {

// Ramps are the fastest changes from one speed to another. The acceleration is 0 at both ends with a finite
// jerk, and the speed is point-symmetric about the middle of the ramp. The acceleration is constant with an
// infinite jerk; the speed jumps if both are infinite. Lengths are mm or rad, as the caller chooses; speeds
// are >= 0, accelerations and jerks > 0, each may be infinite.

/// The phases of a ramp: the acceleration grows for jerk_s, holds for constant_s, and falls for jerk_s.
struct RampPhases {
    double jerk_s = 0;
    double constant_s = 0;
    double acceleration = 0;  ///< The highest of the ramp.

    double duration_s() const { return 2 * jerk_s + constant_s; }
};

/// Returns the phases of a ramp that changes the speed by `change` >= 0, up or down.
RampPhases ramp_phases(double change, double acceleration, double jerk);

/// Returns the length of a ramp between `low_speed` and `low_speed + change`, `change` >= 0. The length is
/// exact even if the change is lost in the rounding of the sum.
double ramp_length_by(double low_speed, double change, double acceleration, double jerk);

/// Returns the time of the ramp from one speed to the other.
double ramp_s(double from_speed, double to_speed, double acceleration, double jerk);

/// Returns the length of the ramp from one speed to the other; the same in both directions.
double ramp_length(double from_speed, double to_speed, double acceleration, double jerk);

/// Returns the change of speed of the ramp up from `from_speed` that takes `length`.
double ramp_gain(double length, double from_speed, double acceleration, double jerk);

/// Returns the speed that the ramp up from `from_speed` reaches after `length`. It is the inverse of
/// ramp_length(), rounded so that ramp_length(from_speed, result) does not exceed `length` except by rounding
/// of the length itself.
///
/// The result is not monotone in `from_speed` if the jerk is finite: a slow start takes longer over the same
/// length and so may end faster than a quicker one. Use reachable_speed() if speeds may still change.
double ramp_end_speed(double length, double from_speed, double acceleration, double jerk);

/// Returns the highest speed up to which a ramp exists within `length` from `from_speed` and from each speed
/// between: the smallest ramp_end_speed() of all starts at `from_speed` or above. It is monotone in `length`
/// and `from_speed`, so that raising a speed at one block never makes a speed at its neighbour infeasible. It
/// equals ramp_end_speed() from a from_speed of acceleration^2 / (2 jerk) on, and is at most 5.6 % below it
/// elsewhere.
double reachable_speed(double length, double from_speed, double acceleration, double jerk);

}  // namespace gsim::motion
