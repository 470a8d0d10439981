#include "base/text/printable.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "base/text/utf8.h"

namespace gsim::text {

namespace {

bool is_control_code(std::uint32_t code) {
    if (code < 0x20) return code != '\n' && code != '\t';
    const bool is_control_character = code >= 0x7f && code <= 0x9f;
    const bool is_separator = code == 0x2028 || code == 0x2029;
    const bool is_direction_mark = code == 0x200e || code == 0x200f || code == 0x61c ||
                                   (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
    return is_control_character || is_separator || is_direction_mark;
}

bool is_plain(char c) {
    return (c >= ' ' && c <= '~') || c == '\n' || c == '\t';
}

}  // namespace

std::string printable(std::string_view text) {
    if (std::all_of(text.begin(), text.end(), is_plain)) return std::string(text);
    std::string printable_text;
    while (!text.empty()) {
        const Character character = first_character(text);
        const std::size_t bytes = std::max<std::size_t>(character.bytes, 1);
        if (character.bytes == 0) {
            printable_text += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
        } else if (is_control_code(character.code)) {
            printable_text += fmt::format("\\u{:04x}", character.code);
        } else {
            printable_text += text.substr(0, bytes);
        }
        text.remove_prefix(bytes);
    }
    return printable_text;
}

bool is_printable(std::string_view text) {
    return std::none_of(text.begin(), text.end(),
                        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

}  // namespace gsim::text
