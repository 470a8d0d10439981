#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/error.h"
#include "cli/command_line.h"

namespace gsim::apps {

/// Reads arguments into the targets of a command line. Returns an exit status if the program has nothing more
/// to do (after --help and --version). The error is a message about unknown words, with suggestions, or about
/// values that are not allowed.
Result<std::optional<int>> parse(const CommandLine& line, std::span<const std::string> arguments);

}  // namespace gsim::apps
