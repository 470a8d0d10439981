#pragma once

#include <vector>

#include "runtime/kinematics/kinematics.h"

namespace gsim::cell {

/// Where the links of a machine are: number 0 is the world, to which the base is fixed, and number i is the
/// link behind joint i - 1. In the world, mm.
using LinkFrames = std::vector<rrs::CartPos>;

/// The links' places for joint values in mm and rad.
LinkFrames link_frames(const kinematics::Kinematics& kinematics, const rrs::JointPos& joints);

/// The line along or about which a joint moves, in the world.
struct JointAxis {
    rrs::JointKind kind;
    Eigen::Vector3d point_mm;
    Eigen::Vector3d direction;  ///< Unit vector.
};

/// The axis of `joint`, where the links stand as told. It is fixed to link `joint`, as numbered above.
JointAxis joint_axis(const kinematics::Kinematics& kinematics, const LinkFrames& links, int joint);

}  // namespace gsim::cell
