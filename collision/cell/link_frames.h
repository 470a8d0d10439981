#pragma once

#include <span>
#include <vector>

#include "motion/kinematics/kinematics.h"

namespace gsim::cell {

/// Where the links of a machine are: number 0 is the world, to which the bases are fixed, and number i is the
/// link behind joint i - 1, whether that carries the tool or the work. Behind them may come links that go by
/// themselves (DriftingLink). In the world, mm.
using LinkFrames = std::vector<rrs::CartPos>;

/// The links' places for joint values in mm and rad.
LinkFrames link_frames(const kinematics::Kinematics& kinematics, const rrs::JointPos& joints);

/// The line along or about which a joint moves, in the world.
struct JointAxis {
    rrs::JointKind kind;
    Eigen::Vector3d point_mm;
    Eigen::Vector3d direction;  ///< Unit vector.
};

/// The axes of all joints, for joint values in mm and rad.
std::vector<JointAxis> joint_axes(const kinematics::Kinematics& kinematics, const rrs::JointPos& joints);

/// The joints that move `link` in the world, the first one before all. A link that goes by itself has two
/// joints of its own, behind those of the machine: the first slides, the second turns. `parents` are the
/// links in which such links go, in their order.
std::vector<int> joints_to(const kinematics::Kinematics& kinematics, int link,
                           std::span<const int> parents = {});

/// The joints that move two links against each other: from `first` back to where their ways from the world
/// part, and on to `second`.
std::vector<int> joints_between(const kinematics::Kinematics& kinematics, int first, int second,
                                std::span<const int> parents = {});

}  // namespace gsim::cell
