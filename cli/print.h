#pragma once

#include <string_view>

namespace gsim::apps {

/// Writes a text to standard output: all output that is not to a file uses this function. It reports the
/// first failure on standard error with its reason, and drops later text; finish_standard_output() turns it
/// into a status.
void print(std::string_view text);

/// Writes a text to standard error. If that cannot be written (its disk is full, its reader has ended), the
/// error cannot be reported and the program continues. Text from files and options must pass
/// text::printable() first.
void print_to_standard_error(std::string_view text);

/// Closes standard output after all work. Returns the exit status: `status`, or kUsageError in place of
/// kSuccess if not all output has arrived. For main() alone.
int finish_standard_output(int status);

}  // namespace gsim::apps
