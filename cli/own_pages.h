#pragma once

#include <optional>
#include <span>
#include <string>

#include "cli/command_line.h"

namespace gsim::apps {

/// Prints what a program that is no part of gsim has beside its work, where the words ask for that: `manual`,
/// its man page, with `others` to see also; `completion SHELL`. The exit status; nothing: they ask for
/// something else.
std::optional<int> print_own_pages(const CommandLine& line, std::span<const std::string> words,
                                   std::span<const std::string> others);

}  // namespace gsim::apps
