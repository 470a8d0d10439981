#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gsim::text {

/// A character of UTF-8 at the beginning of a text.
struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0;  ///< 0: no character.
};

/// Returns the first character of a text that is not empty: the shortest form, no surrogate, at most
/// U+10FFFF.
Character first_character(std::string_view text);

/// Returns a character as text, or nothing if no character has this code.
std::string utf8(std::uint32_t code);

/// True if the complete text is UTF-8.
bool is_utf8(std::string_view text);

}  // namespace gsim::text
