#pragma once

#include "runtime/motion/linuxcnc/law.h"

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
};

/// The motion along a stretch.
struct Profile {
    Law law;
    double brake_s = 0;    ///< How long before its end the way's last braking began.
    double end_speed = 0;  ///< That it goes on with.
};

/// From rest to rest, in whole periods: the controller looks once in a period whether it must brake.
Profile rest_to_rest(const Stretch& stretch, const Clock& clock);

/// From a speed towards another one, in continuous time. Where the length does not suffice the end speed is
/// another one.
Profile from_speed_to_speed(const Stretch& stretch, double start_speed, double end_speed);

/// At constant acceleration from one speed to the other.
Profile ramp(double length, double start_speed, double end_speed);

}  // namespace gsim::motion::linuxcnc
