#pragma once

#include <string_view>

#include "base/toml/toml_writer.h"
#include "controller/services/override_rules.h"

namespace gsim::base {
class TomlSection;
}

namespace gsim::machine {

/// The table of a controller section for the permitted overrides of the operator.
inline constexpr std::string_view kOverridesKey = "overrides";

/// Reads it; its values replace those of `overrides`.
void read_overrides(base::TomlSection& controller, rrs::OverrideRules& overrides);
/// Prints, as one line, the differences of `now` from `base`.
void print_overrides(base::TomlWriter& out, const rrs::OverrideRules& now, const rrs::OverrideRules& base);

}  // namespace gsim::machine
