#pragma once

// For the readers of TOML files alone (toml_section.h).

#include <string_view>
#include <vector>

#include "base/toml/toml_section.h"
#include "base/toml/toml_text.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// The keys of an axis that tell of its drive.
std::vector<std::string_view> drive_keys(AxisKind kind);

/// What an axis says of its drive.
Drive read_drive(base::TomlSection& axis, const toml::table& table, AxisKind kind);

void print_drive(base::TomlText& out, const Axis& axis);

}  // namespace gsim::machine
