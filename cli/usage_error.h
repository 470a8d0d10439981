#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/text/printable.h"
#include "cli/exit_status.h"
#include "cli/print.h"

namespace gsim::apps {

/// Writes "PROGRAM: MESSAGE" to standard error, in a form that is safe for a terminal.
inline void report_error(std::string_view program, std::string_view message) {
    print_to_standard_error(text::printable(fmt::format("{}: {}\n", program, message)));
}

/// Reports an error of options or files; returns the exit status for it.
inline int usage_error(const char* program, const std::string& message) {
    report_error(program, message);
    return kUsageError;
}

}  // namespace gsim::apps
