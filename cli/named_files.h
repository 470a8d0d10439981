#pragma once

#include <optional>
#include <string>

#include "cli/command_line.h"

namespace gsim::apps {

/// Why the files that were given do not go together, as a sentence: an output that is another output, or a
/// file that is read, by whatever name (links, other spellings, redirected standard streams), or two outputs
/// on standard output. For arguments that were parsed, before anything is opened.
std::optional<std::string> find_file_conflict(const CommandLine& line);

}  // namespace gsim::apps
