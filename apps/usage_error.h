#pragma once

#include <cstdio>
#include <string>

#include "apps/exit_status.h"

namespace gsim::apps {

/// What is wrong with options or files, on standard error; the exit status for it.
inline int usage_error(const char* program, const std::string& message) {
    std::fprintf(stderr, "%s: %s\n", program, message.c_str());
    return kUsage;
}

}  // namespace gsim::apps
