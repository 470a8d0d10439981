#pragma once

#include <map>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/os/files.h"

namespace gsim::engine {

/// Returns the permanent variables by number, as a controller keeps them from one run to the next: a text
/// file with `number value` in each line, as LinuxCNC's .var files are. Without such a file the result is
/// empty. The error is a message with file and line.
Result<std::map<int, double>> read_variables(const os::Files& files, const std::string& path);

/// Does the same with the text of such a file.
Result<std::map<int, double>> parse_variables(std::string_view text, std::string_view file_name);

/// Returns the contents of such a file: parse_variables() returns the same values again.
std::string variables_text(const std::map<int, double>& values);

}  // namespace gsim::engine
