#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "base/os/file_handle.h"

namespace gsim::os {

/// Who names a file, and so what may be opened by that name for reading.
enum class NamedBy {
    a_file,        ///< A file or a script: regular files alone. Opening never waits.
    command_line,  ///< Who runs the program: pipes (`<(...)`, FIFOs) and devices, too, whose data are waited
                   ///< for.
};

/// The most bytes of a small file written by hand.
inline constexpr std::size_t kMaxTextFileBytes = std::size_t{4} << 20U;

/// A file that is open for reading bytes.
using InputFile = FileHandle;

/// Opens a file for reading, all that the programs read but standard input. What is opened is what is looked
/// at, so that nothing can take its place in between. The error says why not, without the name: "No such file
/// or directory".
tl::expected<InputFile, std::string> open_input(const std::filesystem::path& path, NamedBy named_by);

/// All bytes of a file of up to `max_bytes`, whole MiB. The error is a sentence with its name.
tl::expected<std::string, std::string> read_input(const std::filesystem::path& path, NamedBy named_by,
                                                  std::size_t max_bytes);

/// The sentence on a file that has more than `max_bytes`.
std::string too_large(const std::filesystem::path& path, std::size_t max_bytes);

/// The bytes of a small file written by hand (at most 4 MiB). The error is a sentence that names the file.
tl::expected<std::string, std::string> read_text_file(const std::filesystem::path& path,
                                                      NamedBy named_by = NamedBy::a_file);

}  // namespace gsim::os
