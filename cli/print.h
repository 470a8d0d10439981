#pragma once

#include <string_view>

namespace gsim::apps {

/// Writes a text to standard output: what is not a file of its own goes there by this alone. The first
/// failure is told on standard error with its reason, and what comes after it is dropped;
/// finish_standard_output() makes a status of it.
void print(std::string_view text);

/// Writes a text to standard error. Where that cannot be written (its disk is full, whoever listened is gone)
/// there is nobody to be told, and what the program is doing goes on. What comes from files and options goes
/// through text::printable() first.
void tell(std::string_view text);

/// Closes standard output when all is done. The exit status: `status`, or kUsage in place of kDone where not
/// all that was printed has arrived. For main() alone.
int finish_standard_output(int status);

}  // namespace gsim::apps
