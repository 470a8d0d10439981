#pragma once

#include <functional>
#include <string>

#include "base/error.h"
#include "cli/command_line.h"

namespace gsim::calibrate {

/// Command that the parsed words of a line selected.
using SelectedCommand = std::function<Result<void>()>;

/// Adds a command to the line and returns it, so that options can be added; if it is selected, `chosen`
/// becomes `does`.
apps::CommandLine& add_command(apps::CommandLine& line, SelectedCommand& selected, const char* name,
                               const char* description, SelectedCommand action);

/// Writes a file, unless its name is empty.
Result<void> write_if_named(const std::string& file, const std::string& text);
/// Writes a file, or to standard output if its name is empty.
Result<void> write_or_print(const std::string& file, const std::string& text);

}  // namespace gsim::calibrate
