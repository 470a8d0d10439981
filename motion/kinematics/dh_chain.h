#pragma once

#include <vector>

#include "motion/kinematics/chain.h"

namespace gsim::kinematics {

/// A chain with joints that all carry the tool, by its table: between a base frame (world to the first joint)
/// and a tool frame (last link to the tool centre point) the rows in the order of the joints.
class DhChain : public Chain {
  public:
    /// Takes at most kMaxJoints links; throws std::invalid_argument beyond.
    DhChain(const rrs::CartPos& base, const std::vector<DhLink>& rows, const rrs::CartPos& tool);
};

/// The joints that move the tool relative to the work, as one table from the work frame to the tool: joints
/// of the work's side come first, the one next to the work before all.
struct DhTable {
    rrs::CartPos base = rrs::CartPos::Identity();  ///< Work frame to the first row.
    std::vector<DhLink> rows = {};
    std::vector<int> joints = {};  ///< Index of the joint of each row.
    rrs::CartPos tool = rrs::CartPos::Identity();
};

/// Returns the table of a chain. A chain made of rows alone gives those rows. Any other is converted by the
/// common normals of its joint axes (Denavit and Hartenberg 1955), exactly but for rounding. Axes that are
/// parallel to 1e-9 rad count as parallel, and then the normal is taken at the position of the frame before.
DhTable dh_table(const Chain& chain);

}  // namespace gsim::kinematics
