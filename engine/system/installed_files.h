#pragma once

#include <filesystem>
#include <string>

#include "base/error.h"
#include "engine/host.h"

namespace gsim::engine {

/// Returns the file that a name on the command line means. A file of that name has priority, and `-` and an
/// empty name do not change. Otherwise it is searched in the installation of the running program. If it is
/// not there either, the error is a message that lists the searched folders.
Result<std::string> find_file(NameKind kind, const std::string& name);

/// Does the same as find_file() with the program in `bin_folder`.
Result<std::string> find_file_from(const std::filesystem::path& bin_folder, NameKind kind,
                                   const std::string& name);

}  // namespace gsim::engine
