#pragma once

#include <optional>
#include <string>

#include "base/error.h"
#include "cli/command_line.h"

namespace gsim::apps {

/// Returns an error if the given files conflict: an output that is another output, or a file that is read,
/// by any name (links, other spellings, redirected standard streams), or two outputs on standard output. To
/// be called with parsed arguments, before anything is opened.
std::optional<Error> find_file_conflict(const CommandLine& line);

}  // namespace gsim::apps
