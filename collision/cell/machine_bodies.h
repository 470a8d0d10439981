#pragma once

#include <memory>
#include <vector>

#include "collision/cell/cell.h"
#include "collision/pairs/body_pair.h"
#include "collision/pairs/leeway.h"

namespace gsim::cell {

/// A body of a machine, or one that it carries.
struct CarriedBody {
    std::size_t item;  ///< Of its cell.
    Role role;
    Body body;
    std::vector<int> joints;  ///< That move it, from its own one back to the world.
};

/// What another machine can meet of a machine: its own bodies, its jet, and what is attached to its links.
/// Not what stands round it, nor what goes by itself.
struct MachineBodies {
    std::shared_ptr<const kinematics::Kinematics> kinematics;  ///< Where it stands in its cell.
    std::vector<CarriedBody> bodies;
};

/// As the frames of the cell are now; it must outlive them. `machine_kinematics` are those of its file.
MachineBodies machine_bodies(const Cell& cell,
                             const std::shared_ptr<const kinematics::Kinematics>& machine_kinematics);

/// How far the joints reach for these bodies, for joint values in mm and rad.
JointReach reach_of(const MachineBodies& machine, const rrs::JointPos& joints);

}  // namespace gsim::cell
