#pragma once

#include <memory>

#include "collision/cell/frame_tree.h"
#include "motion/kinematics/kinematics.h"

namespace gsim::cell {

/// Returns the joints of a machine at the position of its base in a cell. Returns `kinematics` itself if that
/// is the position in the machine's file; otherwise they have no inverse.
std::shared_ptr<const kinematics::Kinematics> placed_kinematics(
    std::shared_ptr<const kinematics::Kinematics> kinematics, const FrameTree& frames);

}  // namespace gsim::cell
