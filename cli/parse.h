#pragma once

#include <optional>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "cli/command_line.h"

namespace gsim::apps {

/// Reads arguments into the targets of a command line. What is left is an exit status where the program has
/// nothing more to do (after --help and --version). The error is a sentence on words that it does not know,
/// with what may have been meant, or on values that are not allowed.
tl::expected<std::optional<int>, std::string> parse(const CommandLine& line,
                                                    std::span<const std::string> arguments);

}  // namespace gsim::apps
