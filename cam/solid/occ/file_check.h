#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gsim::solid {

enum class FileFormat { step, iges };

/// Returns the format by the extension of a file's name.
FileFormat format_by_name(std::string_view name);

/// Returns a message about an invalid beginning or end of a file, or about NUL bytes in it. It detects files
/// of other formats and truncated files, of which OpenCASCADE reads the available part.
std::optional<std::string> find_file_error(std::string_view text, FileFormat format);

}  // namespace gsim::solid
