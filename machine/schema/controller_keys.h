#pragma once

#include <span>
#include <string_view>

#include "controller/services/controller_rules.h"

namespace gsim::base {
class TomlSection;
class TomlWriter;
}  // namespace gsim::base

namespace gsim::machine {

/// Source of the values that the other keys change.
inline constexpr std::string_view kModelKey = "model";

/// Orientation rule of the tool; not every machine supports each.
inline constexpr std::string_view kOrientationKey = "orientation";

/// Returns the keys that a table [controller] may hold, including kModelKey (docs/machine-file.md).
std::span<const std::string_view> controller_keys();

/// Sets the values in `section`, except the model.
void read_controller_keys(base::TomlSection& section, rrs::ControllerRules& rules);

/// Writes the values of `rules` that differ from `base`, except the model.
void print_controller_keys(base::TomlWriter& out, const rrs::ControllerRules& rules,
                           const rrs::ControllerRules& base);

}  // namespace gsim::machine
