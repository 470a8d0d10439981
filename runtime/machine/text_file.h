#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

namespace gsim::machine {

/// The bytes of a small file written by hand (at most 4 MiB). The error is a sentence that names the file.
tl::expected<std::string, std::string> read_text_file(const std::filesystem::path& path);

}  // namespace gsim::machine
