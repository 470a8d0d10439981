#pragma once

#include <cstdint>
#include <string>

#include "base/os/cpu_limit.h"

namespace gsim::simulation {

/// Limits for a run that does not end by its own words.
struct RunLimits {
    double max_time_s = 10'000'000;         ///< Time of the machine.
    std::uint64_t max_blocks = 20'000'000;  ///< Executed blocks.
    os::CpuLimit* cpu = nullptr;            ///< For the full run; null: no limit. It outlives the simulator.
    /// The first violation of a range or a zone is an alarm, which ends the run. If false, the run continues,
    /// and all violations are listed.
    bool stop_at_first = false;
};

/// Returns the message of a run that ends at that limit.
std::string cpu_limit_reached(const os::CpuLimit& limit);

}  // namespace gsim::simulation
