#pragma once

#include <optional>
#include <span>
#include <string>

#include "cli/command_line.h"

namespace gsim::apps {

/// Prints the additional pages of a program that is not part of gsim, if the words request them: `manual`,
/// its man page, with `others` to see also; `completion SHELL`. Returns the exit status; nothing: they
/// request something else.
std::optional<int> print_standalone_pages(const CommandLine& line, std::span<const std::string> words,
                                          std::span<const std::string> others);

}  // namespace gsim::apps
