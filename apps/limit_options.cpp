#include "apps/limit_options.h"

#include "cli/exit_status.h"

namespace gsim::apps {

void add_cpu_option(CommandLine& line, double& seconds) {
    line.add("--max-cpu-seconds", &seconds, "exit after this many seconds of processor time")
        .with_value_name("SECONDS")
        .make_positive()
        .show_default();
}

CpuLimitGuard::CpuLimitGuard(double seconds)
    : limit_(seconds, "error: the processor time exceeds --max-cpu-seconds\n", kProgramError) {}

double guard_limit_s(double seconds) {
    constexpr double kTimeFactor = 1.25;
    constexpr double kMinMargin_s = 2;
    return kTimeFactor * seconds + kMinMargin_s;
}

void add_memory_option(CommandLine& line, std::uint64_t& megabytes) {
    line.add("--memory", &megabytes, "max memory of scripts, including their source and data")
        .with_value_name("MB")
        .within(16, 1 << 20U)
        .show_default();
}

}  // namespace gsim::apps
