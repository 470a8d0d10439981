#pragma once

// Only for the readers of plans, because toml++ is slow to compile.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/text/json.h"
#include "base/toml/toml_section.h"
#include "batch/plan/setting.h"

namespace gsim::batch {

/// Returns a plain value as JSON; empty if it is not plain.
std::optional<nlohmann::json> scalar_value(const toml::node& node);

/// Returns an integer. A value that is not an integer between `min` and `max` is an error.
std::uint64_t read_integer(base::TomlSection& section, std::string_view key, std::uint64_t min,
                           std::uint64_t max, std::uint64_t fallback);

/// Function that returns the file for a name in a plan.
using ResolveFile = std::function<std::string(const std::string& name)>;

/// Reads one [[setting]] of a plan. Returns no setting, or sets `error`, if it is wrong.
std::optional<Setting> read_setting(base::FirstError& error, const toml::table& table,
                                    const ResolveFile& resolve_file);

}  // namespace gsim::batch
