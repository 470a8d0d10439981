#pragma once

#include "controller/services/types.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// Returns a frame as a matrix, in mm.
rrs::CartPos frame_pose(const Frame& frame);

}  // namespace gsim::machine
