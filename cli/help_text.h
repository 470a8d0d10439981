#pragma once

#include <string>

#include "cli/command_line.h"

namespace gsim::apps {

/// What --help prints: usage, options by task, examples, exit statuses. `chosen` is a command of `line` to
/// tell of, or `line` itself.
std::string help_text(const CommandLine& line, const CommandLine* chosen);

/// Lines of at most `width` characters (but for longer words), each behind `indent` blanks.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent);

/// What the exit statuses of all programs mean, as a sentence.
std::string exit_statuses();

}  // namespace gsim::apps
