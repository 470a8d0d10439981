#pragma once

#include <string_view>

#include "base/toml/toml_writer.h"
#include "controller/services/controller_rules.h"

namespace gsim::base {
class TomlSection;
}

namespace gsim::machine {

/// The table of a controller section for the permitted overrides of the operator.
inline constexpr std::string_view kOverridesKey = "overrides";

/// Reads it; its values replace those of `rules`.
void read_overrides(base::TomlSection& controller, rrs::ControllerRules& rules);
/// Prints, as one line, the differences of `rules` from `base`.
void print_overrides(base::TomlWriter& out, const rrs::ControllerRules& rules,
                     const rrs::ControllerRules& base);

}  // namespace gsim::machine
