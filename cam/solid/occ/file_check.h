#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"

namespace gsim::solid {

enum class FileFormat { step, iges };

/// Returns the format by the extension of a file's name.
FileFormat format_by_name(std::string_view name);

/// Returns an error if a file has an invalid beginning or end, or NUL bytes. It detects files
/// of other formats and truncated files, of which OpenCASCADE reads the available part.
std::optional<Error> find_file_error(std::string_view text, FileFormat format);

}  // namespace gsim::solid
