#pragma once

#include <span>
#include <vector>

#include "collision/pairs/body_pair.h"

namespace gsim::cell {

/// How far two bodies are apart along a unit vector in the world: the least place of the first one along it
/// less the greatest of the second; below 0 where no plane across it keeps them apart. Of a mesh its box
/// counts.
double gap_along_mm(const Body& first, const Body& second, const LinkFrames& links,
                    const Eigen::Vector3d& direction);

/// A part of a box of joint values: its middle is where `axes` are, and each joint goes as far as its half on
/// both sides, in mm or rad.
struct JointPart {
    const std::vector<JointAxis>& axes;
    const rrs::JointPos& half;
};

/// For each of the joints `between`, from the body's own one on (joints_between()), how far it can move a
/// point of the body along a unit vector that is fixed to the link behind the last of them, and at the middle
/// of the part is `direction` in the world. A joint that slides across it moves nothing along it, but for
/// what the joints behind it turn its way; a revolute joint's way begins across its lever.
std::vector<double> ways_along_mm(const Ball& body, const JointPart& part, std::span<const int> between,
                                  const Eigen::Vector3d& direction);

}  // namespace gsim::cell
