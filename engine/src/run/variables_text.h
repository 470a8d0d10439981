#pragma once

#include <map>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "base/os/files.h"

namespace gsim::engine {

/// Values of permanent variables by number, as a control keeps them from one run to the next: a text file
/// with `number value` in each line, as LinuxCNC's .var files are. Without such a file there are none. The
/// error is a sentence with file and line.
tl::expected<std::map<int, double>, std::string> read_variables(const os::Files& files,
                                                                const std::string& path);

/// The same of such a file's text.
tl::expected<std::map<int, double>, std::string> variables_of(std::string_view text,
                                                              std::string_view file_name);

/// What such a file holds: variables_of() gives the same values back.
std::string variables_text(const std::map<int, double>& values);

}  // namespace gsim::engine
