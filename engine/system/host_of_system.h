#pragma once

#include "engine/host.h"

namespace gsim::engine {

/// What this machine has: its files, what was installed with the program, the reader of solids (a process of
/// its own), controller modules (shared libraries).
Host host_of_system();

}  // namespace gsim::engine
