#pragma once

#include <span>
#include <string_view>

#include "base/toml/toml_text.h"
#include "controller/services/controller_rules.h"

namespace gsim::base {
class TomlSection;
}

namespace gsim::machine {

/// The table of a controller section that says which words stop the control.
inline constexpr std::string_view kStopsKey = "stops";

/// The words that it may have.
std::span<const std::string_view> stop_words();

/// Reads it over what `rules` have.
void read_stops(base::TomlSection& controller, rrs::ControllerRules& rules);
/// Prints, as one line, in what `rules` differ from `base`.
void print_stops(base::TomlText& out, const rrs::ControllerRules& rules, const rrs::ControllerRules& base);

}  // namespace gsim::machine
