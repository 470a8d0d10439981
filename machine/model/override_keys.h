#pragma once

#include <string_view>

#include "base/toml/toml_text.h"
#include "controller/services/controller_rules.h"

namespace gsim::base {
class TomlSection;
}

namespace gsim::machine {

/// The table of a controller section that says what the control takes of its operator's overrides.
inline constexpr std::string_view kOverridesKey = "overrides";

/// Reads it over what `rules` have.
void read_overrides(base::TomlSection& controller, rrs::ControllerRules& rules);
/// Prints, as one line, in what `rules` differ from `base`.
void print_overrides(base::TomlText& out, const rrs::ControllerRules& rules,
                     const rrs::ControllerRules& base);

}  // namespace gsim::machine
