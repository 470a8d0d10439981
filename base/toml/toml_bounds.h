#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace gsim::base {

/// Max length of a TOML text that is read, in bytes.
inline constexpr std::size_t kMaxTomlBytes = std::size_t{4} << 20;
/// Max number of tables, arrays and inline tables that may be open within each other at one position.
inline constexpr std::size_t kMaxTomlBrackets = 32;
/// Max number of parts that a key or a table's name may have, joined by dots.
inline constexpr std::size_t kMaxTomlKeyParts = 32;

/// Position at which a TOML text exceeds these bounds.
struct TomlBoundsError {
    std::size_t line = 1;
    std::size_t column = 1;  ///< In characters.
    std::string message;
};

/// Returns the first such position, found in one pass without a stack. toml++ parses and destroys tables by
/// recursion, so that a deep text would exhaust its stack.
std::optional<TomlBoundsError> find_toml_bounds_error(std::string_view toml_text);

}  // namespace gsim::base
