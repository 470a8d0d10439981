#pragma once

// Only for readers of TOML files (toml_section.h).

#include <string_view>
#include <vector>

#include "base/toml/toml_section.h"
#include "base/toml/toml_writer.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// Returns the keys of an axis for its drive.
std::vector<std::string_view> drive_keys(AxisKind kind);

/// Reads the drive of an axis.
Drive read_drive(base::TomlSection& axis, const toml::table& table, AxisKind kind);

void print_drive(base::TomlWriter& out, const Axis& axis);

}  // namespace gsim::machine
