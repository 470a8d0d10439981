#pragma once

#include <span>
#include <vector>

#include "motion/kinematics/kinematics.h"

namespace gsim::cell {

/// Poses of the links of a machine: number 0 is the world, to which the bases are fixed. Number i is the link
/// that follows joint i - 1, for a joint that carries the tool or the work. Links that move independently
/// (MovingLink) may follow. Poses are in the world, mm.
using LinkFrames = std::vector<rrs::CartPos>;

/// Returns the poses of the links for joint values in mm and rad.
LinkFrames link_frames(const kinematics::Kinematics& kinematics, const rrs::JointPos& joints);

/// Line along or about which a joint moves, in the world.
struct JointAxis {
    rrs::JointKind kind;
    Eigen::Vector3d point_mm;
    Eigen::Vector3d direction;  ///< Unit vector.
};

/// Returns the axes of all joints, for joint values in mm and rad.
std::vector<JointAxis> joint_axes(const kinematics::Kinematics& kinematics, const rrs::JointPos& joints);

/// Returns the joints that move `link` in the world, starting with the first. A link that moves independently
/// has two joints of its own, which follow those of the machine: the first slides, the second turns.
/// `parents` are the links in which such links move, in their order.
std::vector<int> joints_to(const kinematics::Kinematics& kinematics, int link,
                           std::span<const int> parents = {});

/// Returns the joints that move two links against each other: from `first` back to the point where their
/// paths from the world part, and on to `second`.
std::vector<int> joints_between(const kinematics::Kinematics& kinematics, int first, int second,
                                std::span<const int> parents = {});

}  // namespace gsim::cell
