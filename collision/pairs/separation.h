#pragma once

#include <span>
#include <vector>

#include "collision/pairs/body_pair.h"

namespace gsim::cell {

/// Returns the gap between two bodies along a unit vector in the world: the smallest coordinate of the first
/// along it minus the largest of the second. It is below 0 if no plane across the vector separates them. For
/// a mesh its box counts.
double distance_along_mm(const Body& first, const Body& second, const LinkFrames& links,
                         const Eigen::Vector3d& direction);

/// Part of a box of joint values: its middle is at `axes`, and each joint moves by its half to both sides, in
/// mm or rad.
struct JointPart {
    const std::vector<JointAxis>& axes;
    const rrs::JointPos& half;
};

/// Returns for each of the joints `between`, from the body's own one on (joints_between()), how far it can
/// move a point of the body along a unit vector. The vector is fixed to the link that follows the last of
/// them, and is `direction` in the world at the middle of the part. A joint that slides across it moves
/// nothing along it, except as later joints turn its path. The path of a revolute joint begins across its
/// lever.
std::vector<double> travels_along_mm(const BoundingSphere& body, const JointPart& part,
                                     std::span<const int> between, const Eigen::Vector3d& direction);

}  // namespace gsim::cell
