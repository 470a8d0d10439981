#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "controller/module/rcs_host.h"

namespace gsim::rrs {

/// What a module in a process of its own may take.
struct RcsProcessLimits {
    int answer_ms = 10'000;                    ///< For one service, by the clock on the wall.
    std::uint64_t memory_bytes = 4ULL << 30U;  ///< Of addresses, in all; 0: no limit.
};

/// Begins `program`, gsim-rcs-host, which loads the library at `path`, tries it out as RcsLibrary::load()
/// does, and makes a controller for `machine` that answers from there. The process ends with the module, and
/// with this one, however that ends. What the module prints to standard output goes to standard error.
///
/// Where the process is lost (a crash, exit(), no answer in time, a connection that makes no sense), services
/// answer GSIM_RCS_FAULT from then on and loss() says how. Steps that it had made till then are had.
///
/// The error is a sentence, that of RcsLibrary::load() where it is the module's.
tl::expected<RcsModule, std::string> begin_rcs_process(const std::filesystem::path& program,
                                                       const std::string& path,
                                                       const gsim_rcs_machine& machine,
                                                       RcsProcessLimits limits = {});

}  // namespace gsim::rrs
