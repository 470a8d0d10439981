#pragma once

// Only for readers of TOML files (toml_section.h).

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/toml/toml_section.h"

namespace gsim::machine {

/// Largest magnitude of a number in a file, positive or negative.
inline constexpr double kMaxFileValue = 1e9;

/// Returns the list of finite numbers under `key`, or nothing if the key is missing. Anything else, or a
/// wrong number of values, is an error, which `meaning` explains: "[x, y, z]".
std::optional<std::vector<double>> read_numbers(base::TomlSection& section, const toml::table& table,
                                                std::string_view key, std::string_view meaning,
                                                std::initializer_list<std::size_t> counts = {});

/// Returns such a list in TOML syntax.
std::string number_list(std::span<const double> numbers);

}  // namespace gsim::machine
