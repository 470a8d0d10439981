#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include "engine/host.h"

namespace gsim::engine {

/// The file that a name on the command line means. A file of that name goes before all else, and `-` and an
/// empty name stay as they are. Else it is looked for where the program that runs was installed. Where it is
/// not there either, the error is a sentence that says where it was looked for.
tl::expected<std::string, std::string> find_file(NameKind kind, const std::string& name);

/// find_file() with the program in `bin_folder`.
tl::expected<std::string, std::string> find_file_from(const std::filesystem::path& bin_folder, NameKind kind,
                                                      const std::string& name);

}  // namespace gsim::engine
