#pragma once

#include "engine/host.h"
#include "engine/system/system_host.h"

namespace gsim::engine {

/// Returns make_system_host() that also reads outlines and contours of parts in STEP and IGES files, from
/// which paths are made. Translation and simulation do not need these, nor the readers of drawings.
Host make_parts_host(ModuleProcess isolation = ModuleProcess::separate_process);

}  // namespace gsim::engine
