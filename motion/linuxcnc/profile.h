#pragma once

#include "motion/linuxcnc/law.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion::linuxcnc {

/// Tolerance within which a number of periods counts as an integer.
inline constexpr double kPeriodTolerance = 1e-9;

/// The controller's loop.
struct Clock {
    double period_s = 1e-3;
    bool counts = true;  ///< True: motions take full periods; else only the limits use the period.
};

/// Path section with constant limits.
struct Stretch {
    double length = 0;
    double top_speed = 0;
    double acceleration = 0;
    double jerk = kUnlimited;
};

/// Motion along a path section.
struct Profile {
    Law law;
    double braking_time_s = 0;  ///< Time from the start of the last braking to the end.
    double end_speed = 0;       ///< Speed at its end.
    double end_acceleration = 0;
};

/// Returns the highest speed of a motion over a length from standstill to standstill without any other limit.
double peak_speed(double length, double acceleration, double jerk);

/// Returns the motion from standstill to standstill, in full periods, because the controller checks once in a
/// period if it must brake.
Profile rest_to_rest(const Stretch& section, const Clock& clock);

/// Returns the motion from a speed towards another one, in continuous time. The end speed is a different one
/// if the length does not suffice. The acceleration is 0 at both ends with a finite jerk; the jerk is not
/// kept if the length is too short for that, as in LinuxCNC.
Profile from_speed_to_speed(const Stretch& section, double start_speed, double end_speed);

/// Returns the motion at constant acceleration from one speed to the other.
Profile ramp(double length, double start_speed, double end_speed);

/// Returns the law that takes the acceleration of a motion to 0. The motion then continues with ramps that
/// have acceleration 0 at their ends.
Law acceleration_ramp_down(double speed, double acceleration, double jerk);

/// Returns the law that slows down from a speed at once: to standstill, or to the end if the length is too
/// short, no faster there than `end_speed`.
Profile braking(const Stretch& section, double start_speed, double end_speed);

/// Returns how long before its end the last braking of a profile that ends at standstill falls below `speed`.
double time_below_speed_s(const Profile& profile, double speed);

/// Returns the profile that continues the motion `before` on the same path.
Profile append_profile(const Law& before, const Profile& profile);

}  // namespace gsim::motion::linuxcnc
