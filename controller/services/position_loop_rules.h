#pragma once

namespace gsim::rrs {

/// The axes' position loops, and how long exact stops wait for them.
struct PositionLoopRules {
    double servo_period_s = 0;  ///< Period of the controller's position loop; 0: continuous.
    /// Gain of the axes' position loops: they follow with a speed of this times the following error. Exact
    /// stops wait, before settle_s, until the error is within the band of each joint; 0: they do not.
    double gain_1_s = 0;
    double in_position_mm = 0.01;
    double in_position_deg = 0.01;
    double settle_s = 0;  ///< Time at each exact stop until the axes are in position.

    bool operator==(const PositionLoopRules&) const = default;
};

}  // namespace gsim::rrs
