#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "base/text/json.h"

namespace gsim::base {

/// A document as JSON: dates, and numbers that are not finite, as texts, "inf". The error says where the
/// first fault is: "file:line:column: sentence".
tl::expected<nlohmann::json, std::string> toml_json(std::string_view toml_text, std::string_view file_name);

/// How numbers are written.
enum class TomlNumbers { floats, as_they_are };  ///< 254 as "254.0"; or as "254".

/// A value as TOML has it, on one line.
std::string toml_value(const nlohmann::ordered_json& value, TomlNumbers numbers);

/// Why TOML has no such value, as a sentence; nothing where it has.
std::optional<std::string> find_value_fault(const nlohmann::ordered_json& value);

/// What a plain value that stands in a file is written like.
enum class TomlSpelling { whole, with_point, other };
TomlSpelling spelling_of(std::string_view plain);

/// Whether a text is the name of a number that is not finite: "inf".
bool names_number(std::string_view text);

}  // namespace gsim::base
