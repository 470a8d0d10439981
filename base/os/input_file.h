#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "base/error.h"
#include "base/os/file_handle.h"

namespace gsim::os {

/// Source of a file name, which decides what may be opened by that name for reading.
enum class NameSource {
    in_file,       ///< A file or a script: regular files alone. Opening never waits.
    command_line,  ///< The user of the program: also pipes (`<(...)`, FIFOs) and devices, whose data are
                   ///< waited for.
};

/// Largest size of a small file written by hand, in bytes.
inline constexpr std::size_t kMaxTextFileBytes = std::size_t{4} << 20U;

/// A file that is open for reading bytes.
using InputFile = FileHandle;

/// Opens a file for reading; the programs read everything but standard input by this function. The check is
/// made on the opened file, so that no other file can take its place in between. The error gives the reason
/// without the name: "No such file or directory".
Result<InputFile> open_input(const std::filesystem::path& path, NameSource name_source);

/// Returns all bytes of a file of up to `max_bytes`, a multiple of 1 MiB. The error is a message with its
/// name.
Result<std::string> read_input(const std::filesystem::path& path, NameSource name_source,
                               std::size_t max_bytes);

/// Returns the message for a file that has more than `max_bytes`.
std::string too_large(const std::filesystem::path& path, std::size_t max_bytes);

/// Returns the bytes of a small file written by hand (at most 4 MiB). The error is a message that names the
/// file.
Result<std::string> read_text_file(const std::filesystem::path& path,
                                   NameSource name_source = NameSource::in_file);

}  // namespace gsim::os
