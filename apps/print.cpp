#include "apps/print.h"

#include <cstdio>

#include "apps/exit_status.h"

namespace gsim::apps {

int print(const std::string& text) {
    if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) return kDone;
    std::fputs("standard output cannot be written\n", stderr);
    return kUsage;
}

}  // namespace gsim::apps
