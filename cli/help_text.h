#pragma once

#include <string>

#include "cli/command_line.h"

namespace gsim::apps {

/// Returns the output of --help: usage, options by task, examples, exit statuses. `selected` is a command of
/// `line` to describe, or `line` itself.
std::string help_text(const CommandLine& line, const CommandLine* selected);

/// Returns lines of at most `width` characters (except for longer words), each with `indent` leading blanks.
std::string wrap_text(const std::string& text, std::size_t width, std::size_t indent);

/// Returns the meaning of the exit statuses of all programs, as a message.
std::string exit_statuses();

}  // namespace gsim::apps
