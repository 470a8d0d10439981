#pragma once

// For the readers of TOML files alone (toml_section.h).

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

/// The shape that `section` has under its key 'shape'; its mesh file must be in `folder`, but is not read.
/// Nothing where that is an error.
std::optional<ShapeForm> read_shape(base::FirstError& error, base::TomlSection& section,
                                    const toml::table& table, const std::filesystem::path& folder,
                                    const os::Files& files);

/// The pairs of shapes that a file has under its key 'ignore', by what `find` makes of their names; what it
/// does not find is an error. None without the key.
std::vector<std::pair<std::size_t, std::size_t>> read_ignored(
    base::FirstError& error, base::TomlSection& file, const toml::table& root,
    const std::function<std::optional<std::size_t>(std::string_view)>& find);

}  // namespace gsim::machine
