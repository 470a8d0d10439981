#pragma once

// For the readers of TOML files alone (toml_section.h).

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/toml/toml_section.h"

namespace gsim::machine {

/// The greatest number that a file may hold, either way.
inline constexpr double kMostOfFiles = 1e9;

/// The list of finite numbers under `key`; nothing where there is none. Where it holds anything else, or not
/// as many as are allowed, that is an error, which `meaning` explains: "[x, y, z]".
std::optional<std::vector<double>> read_numbers(base::TomlSection& section, const toml::table& table,
                                                std::string_view key, std::string_view meaning,
                                                std::initializer_list<std::size_t> counts = {});

/// Such a list as TOML has it.
std::string number_list(std::span<const double> numbers);

}  // namespace gsim::machine
