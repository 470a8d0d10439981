#pragma once

#include <span>
#include <string_view>

#include "base/toml/toml_writer.h"
#include "controller/services/controller_rules.h"

namespace gsim::base {
class TomlSection;
}

namespace gsim::machine {

/// The table of a controller section for the words that stop the controller.
inline constexpr std::string_view kStopsKey = "stops";

/// Returns the words that it may have.
std::span<const std::string_view> stop_words();

/// Reads it; its values replace those of `rules`.
void read_stops(base::TomlSection& controller, rrs::ControllerRules& rules);
/// Prints, as one line, the differences of `rules` from `base`.
void print_stops(base::TomlWriter& out, const rrs::ControllerRules& rules, const rrs::ControllerRules& base);

}  // namespace gsim::machine
