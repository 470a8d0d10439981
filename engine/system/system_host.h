#pragma once

#include <cstdint>

#include "engine/host.h"

namespace gsim::engine {

/// The process of a controller module.
enum class ModuleProcess : std::uint8_t {
    separate_process,  ///< In gsim-rcs-host, a separate process; the module's effects on its process stay
                       ///< there.
    this_process,  ///< As a library of this process, which ends with it if it crashes or ends the program.
};

/// Returns the resources of this machine: its files, files installed with the program, the reader of solids
/// (a separate process), controller modules (shared libraries).
Host make_system_host(ModuleProcess isolation = ModuleProcess::separate_process);

}  // namespace gsim::engine
