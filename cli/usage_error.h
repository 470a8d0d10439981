#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/text/printable.h"
#include "cli/exit_status.h"
#include "cli/print.h"

namespace gsim::apps {

/// "PROGRAM: MESSAGE" on standard error, as a terminal may have it.
inline void tell_fault(std::string_view program, std::string_view message) {
    tell(text::printable(fmt::format("{}: {}\n", program, message)));
}

/// What is wrong with options or files; the exit status for it.
inline int usage_error(const char* program, const std::string& message) {
    tell_fault(program, message);
    return kUsage;
}

}  // namespace gsim::apps
