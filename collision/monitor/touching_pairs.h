#pragma once

#include <vector>

#include "collision/cell/cell.h"
#include "collision/pairs/candidate_pairs.h"

namespace gsim::cell {

/// Returns the items of a cell that touch each other at these joint values of a machine, in mm and rad. Only
/// pairs that may meet count (candidate_pairs()), in their order. The jet is not checked. No frame of the
/// cell moves independently.
std::vector<ItemPair> touching_pairs(const Cell& cell, const machine::Machine& machine,
                                     const rrs::JointPos& joints);

}  // namespace gsim::cell
