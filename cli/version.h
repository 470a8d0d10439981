#pragma once

#include <string>
#include <string_view>

namespace gsim::apps {

/// Returns "0.1.0".
std::string_view version();

/// Returns the day of the version, "2026-11-22".
std::string_view release_date();

/// Returns the output of --version: the program with its version, then the parts that it is built with.
std::string version_text(const std::string& program);

}  // namespace gsim::apps
