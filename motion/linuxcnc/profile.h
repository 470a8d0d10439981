#pragma once

#include "motion/linuxcnc/law.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion::linuxcnc {

/// A number of periods that is this near to a whole one is whole.
inline constexpr double kWholePeriods = 1e-9;

/// The controller's loop.
struct Clock {
    double period_s = 1e-3;
    bool counts = true;  ///< Motions take whole periods; else only the limits know of the period.
};

/// A way with constant limits.
struct Stretch {
    double length = 0;
    double top_speed = 0;
    double acceleration = 0;
    double jerk = kUnlimited;
};

/// The motion along a stretch.
struct Profile {
    Law law;
    double brake_s = 0;    ///< How long before its end the way's last braking began.
    double end_speed = 0;  ///< That it goes on with.
    double end_acceleration = 0;
};

/// The highest speed of a motion over a length from rest to rest that nothing else slows.
double peak_speed(double length, double acceleration, double jerk);

/// From rest to rest, in whole periods: the controller looks once in a period whether it must brake.
Profile rest_to_rest(const Stretch& stretch, const Clock& clock);

/// From a speed towards another one, in continuous time. Where the length does not suffice the end speed is
/// another one. With a finite jerk the acceleration is 0 at both ends; where the length is too short for that
/// the jerk is not kept, as in LinuxCNC.
Profile from_speed_to_speed(const Stretch& stretch, double start_speed, double end_speed);

/// At constant acceleration from one speed to the other.
Profile ramp(double length, double start_speed, double end_speed);

/// What a motion does before it goes on by ramps whose acceleration is 0 at their ends: takes its
/// acceleration to 0.
Law easing(double speed, double acceleration, double jerk);

/// Slows down from a speed at once, to rest or, where the length is too short, to its end and no faster there
/// than `end_speed`.
Profile braking(const Stretch& stretch, double start_speed, double end_speed);

/// How long before the end of a profile that ends at rest its last braking comes below `speed`.
double slow_s(const Profile& profile, double speed);

/// Behind what has been done on the same way before.
Profile continued(const Law& before, const Profile& profile);

}  // namespace gsim::motion::linuxcnc
