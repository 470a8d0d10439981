#include "text/printable.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

namespace gsim::text {

namespace {

/// A character of UTF-8 at the beginning of a text.
struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0;  ///< 0: none is there.
};

/// The bits of a byte that begins a character of so many bytes, and the lowest character that needs as many.
struct Lead {
    unsigned char mask;
    unsigned char mark;
    std::size_t bytes;
    std::uint32_t least;
};
constexpr Lead kLeads[] = {
    {0x80, 0x00, 1, 0}, {0xe0, 0xc0, 2, 0x80}, {0xf0, 0xe0, 3, 0x800}, {0xf8, 0xf0, 4, 0x10000}};
constexpr std::uint32_t kLastCharacter = 0x10ffff;
constexpr unsigned kBitsOfNext = 6;

Character first_character(std::string_view text) {
    const auto byte_at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    for (const Lead& lead : kLeads) {
        if ((byte_at(0) & lead.mask) != lead.mark || text.size() < lead.bytes) continue;
        std::uint32_t code = byte_at(0) & static_cast<unsigned char>(~lead.mask);
        for (std::size_t i = 1; i < lead.bytes; ++i) {
            if ((byte_at(i) & 0xc0U) != 0x80U) return {};
            code = (code << kBitsOfNext) | (byte_at(i) & 0x3fU);
        }
        const bool surrogate = code >= 0xd800 && code <= 0xdfff;
        if (code < lead.least || code > kLastCharacter || surrogate) return {};
        return {code, lead.bytes};
    }
    return {};
}

bool acts(std::uint32_t code) {
    if (code < 0x20) return code != '\n' && code != '\t';
    const bool control = code >= 0x7f && code <= 0x9f;
    const bool separates = code == 0x2028 || code == 0x2029;
    const bool directs = code == 0x200e || code == 0x200f || code == 0x61c ||
                         (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
    return control || separates || directs;
}

bool is_plain(char c) {
    return (c >= ' ' && c <= '~') || c == '\n' || c == '\t';
}

}  // namespace

std::string printable(std::string_view text) {
    if (std::all_of(text.begin(), text.end(), is_plain)) return std::string(text);
    std::string shown;
    while (!text.empty()) {
        const Character character = first_character(text);
        const std::size_t bytes = std::max<std::size_t>(character.bytes, 1);
        if (character.bytes == 0) {
            shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
        } else if (acts(character.code)) {
            shown += fmt::format("\\u{:04x}", character.code);
        } else {
            shown += text.substr(0, bytes);
        }
        text.remove_prefix(bytes);
    }
    return shown;
}

}  // namespace gsim::text
