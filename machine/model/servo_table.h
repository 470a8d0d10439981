#pragma once

namespace gsim::machine {

/// The servo loop of an axis (its behaviour is defined in dynamics::ServoLoop).
struct Servo {
    double position_gain_1_s = 0;          ///< 1 or greater; 0: that of the controller.
    double velocity_feed_forward = 0;      ///< From 0 to 1,
    double acceleration_feed_forward = 0;  ///< and so this one.
    double velocity_lag_s = 0;             ///< Time constant of the velocity loop.
    double command_delay_s = 0;            ///< Delay of the set points of the loop.

    bool operator==(const Servo&) const = default;
};

}  // namespace gsim::machine
