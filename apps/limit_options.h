#pragma once

#include <cstdint>

#include "base/os/cpu_limit.h"
#include "cli/command_line.h"
#include "engine/request.h"

namespace gsim::apps {

/// The defaults of --max-cpu-seconds (a day, which no run needs) and --memory.
inline constexpr double kMaxCpu_s = engine::Limits{}.cpu_s;
inline constexpr std::uint64_t kMemory_mb = engine::Limits{}.memory_bytes >> 20U;

/// --max-cpu-seconds, which several programs have; in the group begun last.
void add_cpu_option(CommandLine& line, double& seconds);
/// What holds --max-cpu-seconds where nothing asks for the place; see os::ProcessCpuLimit.
class CpuBackstop {
  public:
    explicit CpuBackstop(double seconds);

  private:
    os::ProcessCpuLimit limit_;
};

/// Seconds for a CpuBackstop of a run that asks by itself, and tells the place, if it can.
double behind_own_limit_s(double seconds);

/// --memory, the same.
void add_memory_option(CommandLine& line, std::uint64_t& megabytes);

}  // namespace gsim::apps
