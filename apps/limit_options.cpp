#include "apps/limit_options.h"

#include "cli/exit_status.h"

namespace gsim::apps {

void add_cpu_option(CommandLine& line, double& seconds) {
    line.add("--max-cpu-seconds", &seconds, "end after this many seconds of processor time, wherever it is")
        .with_value_name("SECONDS")
        .make_positive()
        .show_default();
}

CpuBackstop::CpuBackstop(double seconds)
    : limit_(seconds, "error: the processor time that --max-cpu-seconds allows is used up\n", kProgramError) {
}

double backstop_limit_s(double seconds) {
    constexpr double kTimeFactor = 1.25;
    constexpr double kMinMargin_s = 2;
    return kTimeFactor * seconds + kMinMargin_s;
}

void add_memory_option(CommandLine& line, std::uint64_t& megabytes) {
    line.add("--memory", &megabytes, "memory that scripts may use, with their texts and what they make")
        .with_value_name("MB")
        .within(16, 1 << 20U)
        .show_default();
}

}  // namespace gsim::apps
