#pragma once

#include <vector>

#include "machine/model/joint_box.h"

namespace gsim::check {

/// Values of one joint at which the tool has lost a direction to move in, whatever the other joints do.
struct SingularRange {
    int joint;
    double low;  ///< mm or rad, to half a step of the search.
    double high;
    std::vector<int>
        aligned_joints;  ///< Joints that can then move against each other while the tool is at standstill.
};

/// Configurations in which the tool can hardly be moved in some direction: near singular ones joints must
/// turn fast. For a machine with five joints or fewer the rotation of the tool about itself does not count.
struct SingularCheck {
    std::vector<SingularRange> ranges;
    /// Share of the configurations in the joints' box, by samples, in which a speed of the tool needs more
    /// than 100 times as much of a joint. Lengths are counted in the chain's reach per rad.
    double near_share = 0;
    bool at_home = false;  ///< Home is such a configuration.
};

SingularCheck check_singular(const machine::Machine& machine, const machine::JointBox& box);

}  // namespace gsim::check
