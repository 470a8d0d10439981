#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace gsim::base {

/// The longest text of TOML that is read, in bytes.
inline constexpr std::size_t kMaxTomlBytes = std::size_t{4} << 20;
/// The most tables, arrays and inline tables that may be open within each other at one place.
inline constexpr std::size_t kMaxTomlBrackets = 32;
/// The most parts that a key or a table's name may have, joined by dots.
inline constexpr std::size_t kMaxTomlKeyParts = 32;

/// Where a text of TOML goes beyond these bounds.
struct TomlExcess {
    std::size_t line = 1;
    std::size_t column = 1;  ///< In characters.
    std::string sentence;
};

/// The first such place, found in one pass without a stack: toml++ parses and destroys tables by recursion,
/// so that a deep text would leave it without stack.
std::optional<TomlExcess> find_toml_excess(std::string_view toml_text);

}  // namespace gsim::base
