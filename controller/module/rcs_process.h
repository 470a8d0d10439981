#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/error.h"
#include "controller/module/rcs_host.h"

namespace gsim::rrs {

/// Limits of a module in a separate process.
struct RcsProcessLimits {
    int response_timeout_ms = 10'000;          ///< For one service, by the clock on the wall.
    std::uint64_t memory_bytes = 4ULL << 30U;  ///< Total address space; 0: no limit.
};

/// Starts `program`, gsim-rcs-host, which loads the library at `path`, tries it as RcsLibrary::load() does,
/// and creates a controller for `machine` that responds from there. The process ends with the module, and
/// with this one, however that ends. Prints of the module to standard output are written to standard error.
///
/// If the process is lost (a crash, exit(), no response in time, a connection with invalid data), services
/// return GSIM_RCS_FAULT from then on and loss() returns the reason. Steps made before the loss are still
/// delivered.
///
/// The error is a message, that of RcsLibrary::load() if it is the module's.
Result<RcsModule> start_rcs_process(const std::filesystem::path& program, const std::string& path,
                                    const gsim_rcs_machine& machine, RcsProcessLimits limits = {});

}  // namespace gsim::rrs
