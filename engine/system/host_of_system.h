#pragma once

#include <cstdint>

#include "engine/host.h"

namespace gsim::engine {

/// Where a controller module runs.
enum class ModulePlace : std::uint8_t {
    own_process,   ///< In gsim-rcs-host, beside the program; what the module does to its process is its own.
    this_process,  ///< As a library of this process, which goes with it where it crashes or ends the program.
};

/// What this machine has: its files, what was installed with the program, the reader of solids (a process of
/// its own), controller modules (shared libraries).
Host host_of_system(ModulePlace place = ModulePlace::own_process);

}  // namespace gsim::engine
