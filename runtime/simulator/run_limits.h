#pragma once

#include <cstdint>
#include <string>

#include "base/os/cpu_limit.h"

namespace gsim::simulation {

/// Bounds of a run that ends itself by none of its own words.
struct RunLimits {
    double max_time_s = 10'000'000;         ///< Of the machine.
    std::uint64_t max_blocks = 20'000'000;  ///< Executed blocks.
    os::CpuLimit* cpu = nullptr;            ///< Of the whole run; null: none. It outlives the simulator.
    /// The first violation of a range or a zone is an alarm, which ends the run; else it goes on, and all are
    /// listed.
    bool stop_at_first = false;
};

/// What a run says that ends at that limit.
std::string cpu_limit_reached(const os::CpuLimit& limit);

}  // namespace gsim::simulation
