#pragma once

#include <string>

#include <tl/expected.hpp>

#include "controller/services/types.h"

namespace gsim::kinematics {

/// A pose as people write it: position in mm; roll about Z, pitch about Y, yaw about X in rad, so that the
/// rotation is R = Rz(roll) Ry(pitch) Rx(yaw).
struct Rpy {
    double x_mm = 0, y_mm = 0, z_mm = 0;
    double roll_rad = 0, pitch_rad = 0, yaw_rad = 0;
};

rrs::CartPos pose_from_rpy(const Rpy& rpy);

/// The angles of a pose, pitch in [-pi/2, pi/2], the others in [-pi, pi]. With pitch at +-pi/2 only the sum
/// or difference of roll and yaw shows; yaw is 0 then.
Rpy rpy_from_pose(const rrs::CartPos& pose);

/// Whether a matrix is a pose: finite, a right-handed rotation to 1e-6, last row 0 0 0 1. The error is a
/// sentence.
tl::expected<void, std::string> check_pose(const rrs::CartPos& pose);

}  // namespace gsim::kinematics
