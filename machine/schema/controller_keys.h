#pragma once

#include <span>
#include <string_view>

#include "controller/services/controller_rules.h"

namespace gsim::base {
class TomlSection;
class TomlText;
}  // namespace gsim::base

namespace gsim::machine {

/// Where the values come from that the other keys change.
inline constexpr std::string_view kModelKey = "model";

/// How the tool turns; not every machine can do each.
inline constexpr std::string_view kOrientationKey = "orientation";

/// The keys that a table [controller] may hold, kModelKey among them (docs/machine-file.md).
std::span<const std::string_view> controller_keys();

/// Sets what `section` gives, but for the model.
void read_controller_keys(base::TomlSection& section, rrs::ControllerRules& rules);

/// Writes what is another value in `rules` than in `base`, but for the model.
void print_controller_keys(base::TomlText& out, const rrs::ControllerRules& rules,
                           const rrs::ControllerRules& base);

}  // namespace gsim::machine
