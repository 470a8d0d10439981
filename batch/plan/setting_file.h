#pragma once

// For the readers of plans alone: toml++ is slow to compile.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/text/json.h"
#include "base/toml/toml_section.h"
#include "batch/plan/setting.h"

namespace gsim::batch {

/// A plain value as JSON; nothing where it is none.
std::optional<nlohmann::json> plain_value(const toml::node& node);

/// A whole number; what is none between these is an error.
std::uint64_t whole_number(base::TomlSection& section, std::string_view key, std::uint64_t least,
                           std::uint64_t most, std::uint64_t fallback);

/// The file that a plan means by a name.
using FileOf = std::function<std::string(const std::string& name)>;

/// One [[setting]] of a plan. Nothing, or an error beside it, where it is wrong.
std::optional<Setting> read_setting(base::FirstError& error, const toml::table& table, const FileOf& file_of);

}  // namespace gsim::batch
