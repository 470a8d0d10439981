#pragma once

#include <span>
#include <string>

#include "cli/command_line.h"

namespace gsim::apps {

/// Returns the man page of a program in section 1, in roff (man(7)); `others` are the pages to see also.
std::string man_page(const CommandLine& line, std::span<const std::string> others);

}  // namespace gsim::apps
