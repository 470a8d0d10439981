#pragma once

#include <cstdint>

#include "base/os/cpu_limit.h"
#include "cli/command_line.h"
#include "engine/request.h"

namespace gsim::apps {

/// Defaults of --max-cpu-seconds (a day, which no run needs) and --memory.
inline constexpr double kMaxCpu_s = engine::Limits{}.cpu_s;
inline constexpr std::uint64_t kDefaultMemory_mb = engine::Limits{}.memory_bytes >> 20U;

/// Adds --max-cpu-seconds, an option of several programs, to the group begun last.
void add_cpu_option(CommandLine& line, double& seconds);
/// Guard that enforces --max-cpu-seconds if no code checks the limit and knows the source location; see
/// os::ProcessCpuLimit.
class CpuLimitGuard {
  public:
    explicit CpuLimitGuard(double seconds);

  private:
    os::ProcessCpuLimit limit_;
};

/// Returns the seconds for the CpuLimitGuard of a run that checks the limit itself and, if it can, reports
/// the source location.
double guard_limit_s(double seconds);

/// Adds --memory in the same group.
void add_memory_option(CommandLine& line, std::uint64_t& megabytes);

}  // namespace gsim::apps
