#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gsim::solid {

enum class FileFormat { step, iges };

/// By the ending of a file's name.
FileFormat format_by_name(std::string_view name);

/// What is wrong with how a file begins and ends, or that it holds NUL bytes: files of other formats and
/// files that were cut off, of which OpenCASCADE reads what there is. A sentence.
std::optional<std::string> find_frame_fault(std::string_view text, FileFormat format);

}  // namespace gsim::solid
