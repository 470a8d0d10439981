#pragma once

#include "engine/api.h"

namespace gsim::engine {

/// Returns "0.1.0".
GSIM_API const char* version();

}  // namespace gsim::engine
