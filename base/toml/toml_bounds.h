#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "base/error.h"

namespace gsim::base {

/// Max length of a TOML text that is read, in bytes.
inline constexpr std::size_t kMaxTomlBytes = std::size_t{4} << 20;
/// Max number of tables, arrays and inline tables that may be open within each other at one position.
inline constexpr std::size_t kMaxTomlBrackets = 32;
/// Max number of parts that a key or a table's name may have, joined by dots.
inline constexpr std::size_t kMaxTomlKeyParts = 32;

/// Returns an error with the first position where a TOML text exceeds these bounds; its column is in
/// characters. The text is read in one pass without a stack. toml++ parses and destroys tables by recursion,
/// so that a deep text would exhaust its stack.
std::optional<Error> find_toml_bounds_error(std::string_view toml_text);

}  // namespace gsim::base
