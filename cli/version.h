#pragma once

#include <string>
#include <string_view>

namespace gsim::apps {

/// "0.1.0".
std::string_view version();

/// The day of the version, "2026-11-22".
std::string_view release_date();

/// What --version prints: the program with its version, then the parts that it is built with.
std::string version_text(const std::string& program);

}  // namespace gsim::apps
