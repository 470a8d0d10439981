#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "os/input_file.h"

namespace gsim::machine {

/// The bytes of a small file written by hand (at most 4 MiB). The error is a sentence that names the file.
tl::expected<std::string, std::string> read_text_file(const std::filesystem::path& path,
                                                      os::NamedBy named_by = os::NamedBy::a_file);

}  // namespace gsim::machine
