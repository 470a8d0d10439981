#pragma once

#include "runtime/machine/machine.h"
#include "runtime/rrs/types.h"

namespace gsim::machine {

/// A frame as a matrix, in mm.
rrs::CartPos frame_pose(const Frame& frame);

}  // namespace gsim::machine
