#pragma once

#include <string>

#include <tl/expected.hpp>

#include "controller/services/types.h"

namespace gsim::kinematics {

/// Pose in user notation: position in mm; roll about Z, pitch about Y, yaw about X in rad, so that the
/// rotation is R = Rz(roll) Ry(pitch) Rx(yaw).
struct Rpy {
    double x_mm = 0, y_mm = 0, z_mm = 0;
    double roll_rad = 0, pitch_rad = 0, yaw_rad = 0;
};

rrs::CartPos pose_from_rpy(const Rpy& rpy);

/// Returns the angles of a pose, pitch in [-pi/2, pi/2], the others in [-pi, pi]. Only the sum or difference
/// of roll and yaw is defined at a pitch of +-pi/2; yaw is 0 then.
Rpy rpy_from_pose(const rrs::CartPos& pose);

/// Checks that a matrix is a pose: finite, a right-handed rotation to 1e-6, last row 0 0 0 1. The error is a
/// message.
tl::expected<void, std::string> check_pose(const rrs::CartPos& pose);

}  // namespace gsim::kinematics
