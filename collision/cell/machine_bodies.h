#pragma once

#include <memory>
#include <vector>

#include "collision/cell/cell.h"
#include "collision/pairs/body_pair.h"
#include "collision/pairs/separation_budget.h"

namespace gsim::cell {

/// Body of a machine, or one that it carries.
struct CarriedBody {
    std::size_t item;  ///< Item of its cell.
    Role role;
    Body body;
    std::vector<int> joints;  ///< Joints that move it, from its own back to the world.
};

/// Bodies of a machine that another machine can meet: its own bodies, its jet, and what is attached to its
/// links. Excludes its surroundings, and what moves independently.
struct MachineBodies {
    std::shared_ptr<const kinematics::Kinematics> kinematics;  ///< As positioned in its cell.
    std::vector<CarriedBody> bodies;
};

/// Returns the bodies with the current frames of the cell, which must outlive them. `machine_kinematics` are
/// those of its file.
MachineBodies machine_bodies(const Cell& cell,
                             const std::shared_ptr<const kinematics::Kinematics>& machine_kinematics);

/// Returns how far the joints reach for these bodies, for joint values in mm and rad.
JointReach joint_reach(const MachineBodies& machine, const rrs::JointPos& joints);

}  // namespace gsim::cell
