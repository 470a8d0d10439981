#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gsim::text {

/// A character of UTF-8 at the beginning of a text.
struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0;  ///< 0: none is there.
};

/// The first character of a text that is not empty: the shortest form, no surrogate, at most U+10FFFF.
Character first_character(std::string_view text);

/// A character as text; nothing where there is none of this code.
std::string utf8(std::uint32_t code);

/// Whether all of a text is UTF-8.
bool is_utf8(std::string_view text);

}  // namespace gsim::text
