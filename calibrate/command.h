#pragma once

#include <functional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "apps/command_line.h"

namespace gsim::calibrate {

/// What a command comes to; the error is a sentence.
using Done = tl::expected<void, std::string>;

/// Reads the words of a command into the targets of its line, then does it. The exit status; errors are told.
int run_command(const apps::CommandLine& line, const std::vector<std::string>& words,
                const std::function<Done()>& command);

/// Writes a file; none where it has no name.
Done write_if(const std::string& file, const std::string& text);
/// Writes a file, or where it has no name to standard output.
Done write_or_print(const std::string& file, const std::string& text);

}  // namespace gsim::calibrate
