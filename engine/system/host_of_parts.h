#pragma once

#include "engine/host.h"
#include "engine/system/host_of_system.h"

namespace gsim::engine {

/// Returns host_of_system() that also reads outlines and contours of parts in STEP and IGES files, from which
/// paths are made. Translation and simulation do not need these, nor the readers of drawings.
Host host_of_parts(ModulePlace place = ModulePlace::own_process);

}  // namespace gsim::engine
