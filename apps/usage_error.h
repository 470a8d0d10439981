#pragma once

#include <string>

#include <fmt/format.h>

#include "apps/exit_status.h"
#include "apps/print.h"
#include "base/text/printable.h"

namespace gsim::apps {

/// What is wrong with options or files, on standard error; the exit status for it.
inline int usage_error(const char* program, const std::string& message) {
    tell(text::printable(fmt::format("{}: {}\n", program, message)));
    return kUsage;
}

}  // namespace gsim::apps
