#pragma once

#include <functional>
#include <string>

#include "base/error.h"
#include "cli/command_line.h"
#include "machine/model/machine.h"

namespace gsim::calibrate {

/// Command that the parsed words of a line selected.
using SelectedCommand = std::function<Result<void>()>;

/// Adds a command to the line and returns it, so that options can be added; if it is selected, `selected`
/// becomes `action`.
apps::CommandLine& add_command(apps::CommandLine& line, SelectedCommand& selected, const char* name,
                               const char* description, SelectedCommand action);

/// Reads a machine file, and prints its warnings on standard error.
Result<machine::Machine> read_machine_argument(const std::string& file);

/// Writes a file, unless its name is empty.
Result<void> write_if_named(const std::string& file, const std::string& text);
/// Writes a file, or to standard output if its name is empty.
Result<void> write_or_print(const std::string& file, const std::string& text);

}  // namespace gsim::calibrate
