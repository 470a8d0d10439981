#pragma once

#include <memory>

#include "collision/cell/frame_tree.h"
#include "motion/kinematics/kinematics.h"

namespace gsim::cell {

/// The joints of a machine where its base stands in a cell: `kinematics` itself where that is where the
/// machine's file has it; else they have no inverse.
std::shared_ptr<const kinematics::Kinematics> placed_kinematics(
    std::shared_ptr<const kinematics::Kinematics> kinematics, const FrameTree& frames);

}  // namespace gsim::cell
