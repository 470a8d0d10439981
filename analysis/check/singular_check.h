#pragma once

#include <vector>

#include "machine/model/joint_box.h"

namespace gsim::check {

/// Values of one joint at which the tool has lost a direction to move in, whatever the other joints do.
struct SingularRange {
    int joint;
    double low;  ///< mm or rad, to half a step of the search.
    double high;
    std::vector<int> lined_up;  ///< The joints that can then move against each other while the tool stands.
};

/// Where the tool can hardly be moved in some direction: near singular stances joints must turn fast. Of a
/// machine with five joints or fewer the turn of the tool about itself does not count.
struct SingularCheck {
    std::vector<SingularRange> ranges;
    /// Share of the stances in the joints' box, by samples, in which a speed of the tool asks for more than
    /// 100 times as much of a joint, lengths counted in the chain's reach per rad.
    double near_share = 0;
    bool at_home = false;  ///< Home is such a stance.
};

SingularCheck check_singular(const machine::Machine& machine, const machine::JointBox& box);

}  // namespace gsim::check
