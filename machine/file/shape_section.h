#pragma once

// Only for readers of TOML files (toml_section.h).

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/os/files.h"
#include "base/toml/toml_section.h"
#include "machine/model/link_shape.h"

namespace gsim::machine {

/// Returns the shape of `section` under its key 'shape'; its mesh file must be in `folder`, but is not read.
/// Returns nothing if that is an error.
std::optional<ShapeForm> read_shape(base::FirstError& error, base::TomlSection& section,
                                    const toml::table& table, const std::filesystem::path& folder,
                                    const os::Files& files);

/// Returns the pairs of shapes under the key 'ignore' of a file; `find` resolves their names. An unknown name
/// is an error. Returns none without the key.
std::vector<std::pair<std::size_t, std::size_t>> read_ignored(
    base::FirstError& error, base::TomlSection& file, const toml::table& root,
    const std::function<std::optional<std::size_t>(std::string_view)>& find);

}  // namespace gsim::machine
