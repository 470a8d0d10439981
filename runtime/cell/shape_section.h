#pragma once

// For the readers of TOML files alone (toml_section.h).

#include <filesystem>
#include <optional>

#include "runtime/cell/shape.h"
#include "runtime/machine/toml_section.h"

namespace gsim::cell {

/// The shape that `section` has under its key 'shape'; its mesh file is looked for in `folder`. Nothing where
/// that is an error.
std::optional<Shape> read_shape(machine::FirstError& error, machine::TomlSection& section,
                                const toml::table& table, const std::filesystem::path& folder);

}  // namespace gsim::cell
