#pragma once

#include <span>
#include <string_view>

#include "base/toml/toml_writer.h"
#include "controller/services/standstill_rules.h"

namespace gsim::base {
class TomlSection;
}

namespace gsim::machine {

/// The table of a controller section for the words that stop the controller.
inline constexpr std::string_view kStopsKey = "stops";

/// Returns the words that it may have.
std::span<const std::string_view> stop_words();

/// Reads it; its values replace those of `standstill.stops`.
void read_stops(base::TomlSection& controller, rrs::StandstillRules& standstill);
/// Prints, as one line, the differences of `standstill.stops` from those of `base`.
void print_stops(base::TomlWriter& out, const rrs::StandstillRules& standstill,
                 const rrs::StandstillRules& base);

}  // namespace gsim::machine
