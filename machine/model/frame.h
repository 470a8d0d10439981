#pragma once

namespace gsim::machine {

/// Fixed frame: translation in mm, then roll about Z, pitch about Y, yaw about X in degrees (Rz Ry Rx).
struct Frame {
    double x_mm = 0, y_mm = 0, z_mm = 0;
    double roll_deg = 0, pitch_deg = 0, yaw_deg = 0;

    bool operator==(const Frame&) const = default;
};

}  // namespace gsim::machine
