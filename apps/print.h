#pragma once

#include <string>

namespace gsim::apps {

/// Writes a text to standard output; the exit status, with a sentence on standard error where it cannot be
/// written.
int print(const std::string& text);

}  // namespace gsim::apps
