#include "apps/limit_options.h"

namespace gsim::apps {

void add_cpu_option(CommandLine& line, double& seconds) {
    line.add("--max-cpu-seconds", &seconds, "end after this many seconds of processor time, wherever it is")
        .called("SECONDS")
        .above_zero()
        .shows_default();
}

void add_memory_option(CommandLine& line, std::uint64_t& megabytes) {
    line.add("--memory", &megabytes, "memory that scripts may use, with their texts and what they make")
        .called("MB")
        .within(16, 1 << 20U)
        .shows_default();
}

}  // namespace gsim::apps
