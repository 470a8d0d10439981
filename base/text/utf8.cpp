#include "base/text/utf8.h"

#include <algorithm>
#include <iterator>

namespace gsim::text {

namespace {

/// The bits of a byte that begins a character of this number of bytes, and the lowest character that needs as
/// many.
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

bool is_character(std::uint32_t code) {
    return code <= kLastCharacter && (code < 0xd800 || code > 0xdfff);  // those between are surrogates
}

}  // namespace

Character first_character(std::string_view text) {
    const auto byte_at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    for (const Lead& lead : kLeads) {
        if ((byte_at(0) & lead.mask) != lead.mark || text.size() < lead.bytes) continue;
        std::uint32_t code = byte_at(0) & static_cast<unsigned char>(~lead.mask);
        for (std::size_t i = 1; i < lead.bytes; ++i) {
            if ((byte_at(i) & 0xc0U) != 0x80U) return {};
            code = (code << kBitsOfNext) | (byte_at(i) & 0x3fU);
        }
        if (code < lead.least || !is_character(code)) return {};
        return {code, lead.bytes};
    }
    return {};
}

std::string utf8(std::uint32_t code) {
    if (!is_character(code)) return {};
    const auto lead = std::find_if(std::rbegin(kLeads), std::rend(kLeads),
                                   [&](const Lead& each) { return code >= each.least; });
    std::string text(lead->bytes, '\0');
    for (std::size_t i = lead->bytes - 1; i > 0; --i) {
        text[i] = static_cast<char>(0x80U | (code & 0x3fU));
        code >>= kBitsOfNext;
    }
    text[0] = static_cast<char>(lead->mark | code);
    return text;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const Character character = first_character(text);
        if (character.bytes == 0) return false;
        text.remove_prefix(character.bytes);
    }
    return true;
}

}  // namespace gsim::text
