#pragma once

#include <vector>

#include "collision/cell/cell.h"
#include "collision/pairs/meeting_pairs.h"

namespace gsim::cell {

/// The items of a cell that touch each other where a machine stands, for joint values in mm and rad; of pairs
/// that may meet (meeting_pairs()), in their order. The jet is not looked at. No frame of the cell goes by
/// itself.
std::vector<ItemPair> touching_pairs(const Cell& cell, const machine::Machine& machine,
                                     const rrs::JointPos& joints);

}  // namespace gsim::cell
