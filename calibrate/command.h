#pragma once

#include <functional>
#include <string>

#include <tl/expected.hpp>

#include "cli/command_line.h"

namespace gsim::calibrate {

/// What a command comes to; the error is a sentence.
using Done = tl::expected<void, std::string>;

/// The command that was chosen by the words of a line that were read.
using Chosen = std::function<Done()>;

/// A command of the line, for its options to be added to; `does` becomes what is chosen with it.
apps::CommandLine& add_command(apps::CommandLine& line, Chosen& chosen, const char* name,
                               const char* description, Chosen does);

/// Writes a file; none where it has no name.
Done write_if(const std::string& file, const std::string& text);
/// Writes a file, or where it has no name to standard output.
Done write_or_print(const std::string& file, const std::string& text);

}  // namespace gsim::calibrate
