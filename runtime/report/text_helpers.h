#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "runtime/report/report.h"

namespace gsim::simulation {

// Words of reports for people.

inline constexpr std::size_t kLineWidth = 100;

/// Removes what a terminal would take as a command, because names and messages come from files of untrusted
/// users.
std::string sanitized(std::string_view text);
/// Returns the end of a long name, which says more than its beginning.
std::string truncated(std::string_view text, std::size_t width);
/// "part.nc:12"
std::string location_text(const Report& report, const SourceLocation& location, std::size_t width = 40);

}  // namespace gsim::simulation
