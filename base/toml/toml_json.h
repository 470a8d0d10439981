#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/text/json.h"

namespace gsim::base {

/// Returns a document as JSON; dates, and numbers that are not finite, become texts, "inf". The error gives
/// the position of the first error: "file:line:column: message".
Result<nlohmann::json> toml_json(std::string_view toml_text, std::string_view file_name);

/// Format in which numbers are written.
enum class TomlNumbers { floats, as_given };  ///< 254 as "254.0"; or as "254".

/// Returns a value in TOML syntax, on one line.
std::string toml_value(const nlohmann::ordered_json& value, TomlNumbers numbers);

/// Returns an error if TOML has no such value.
std::optional<Error> find_value_error(const nlohmann::ordered_json& value);

/// Format of a plain value in a file.
enum class TomlNumberFormat { integer_spelling, decimal, other };
TomlNumberFormat number_format(std::string_view plain);

/// True if a text is the name of a number that is not finite: "inf".
bool is_nonfinite_name(std::string_view text);

}  // namespace gsim::base
