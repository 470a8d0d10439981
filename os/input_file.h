#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include <tl/expected.hpp>

namespace gsim::os {

/// Who names a file, and so what may be opened by that name for reading.
enum class NamedBy {
    a_file,        ///< A file or a script: regular files alone. Opening never waits.
    command_line,  ///< Who runs the program: pipes (`<(...)`, FIFOs) and devices, too, whose data are waited
                   ///< for.
};

struct CloseInput {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// A file that is open for reading bytes.
using InputFile = std::unique_ptr<std::FILE, CloseInput>;

/// Opens a file for reading, all that the programs read but standard input. What is opened is what is looked
/// at, so that nothing can take its place in between. The error says why not, without the name: "No such file
/// or directory".
tl::expected<InputFile, std::string> open_input(const std::filesystem::path& path, NamedBy named_by);

/// All bytes of a file of up to `max_bytes`, whole MiB. The error is a sentence with its name.
tl::expected<std::string, std::string> read_input(const std::filesystem::path& path, NamedBy named_by,
                                                  std::size_t max_bytes);

}  // namespace gsim::os
