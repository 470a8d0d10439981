#include "base/text/utf8.h"

#include <algorithm>
#include <iterator>

namespace gsim::text {

namespace {

/// The bits of a byte that begins a character of this number of bytes, and the lowest character that needs as
/// many.
struct LeadByte {
    unsigned char mask;
    unsigned char mark;
    std::size_t bytes;
    std::uint32_t min;
};
constexpr LeadByte kLeadBytes[] = {
    {0x80, 0x00, 1, 0}, {0xe0, 0xc0, 2, 0x80}, {0xf0, 0xe0, 3, 0x800}, {0xf8, 0xf0, 4, 0x10000}};
constexpr std::uint32_t kLastCharacter = 0x10ffff;
constexpr unsigned kContinuationBits = 6;

bool is_character(std::uint32_t code) {
    return code <= kLastCharacter && (code < 0xd800 || code > 0xdfff);  // those between are surrogates
}

}  // namespace

Character first_character(std::string_view text) {
    const auto byte_at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    for (const LeadByte& lead_byte : kLeadBytes) {
        if ((byte_at(0) & lead_byte.mask) != lead_byte.mark || text.size() < lead_byte.bytes) continue;
        std::uint32_t code = byte_at(0) & static_cast<unsigned char>(~lead_byte.mask);
        for (std::size_t i = 1; i < lead_byte.bytes; ++i) {
            if ((byte_at(i) & 0xc0U) != 0x80U) return {};
            code = (code << kContinuationBits) | (byte_at(i) & 0x3fU);
        }
        if (code < lead_byte.min || !is_character(code)) return {};
        return {code, lead_byte.bytes};
    }
    return {};
}

std::string utf8(std::uint32_t code) {
    if (!is_character(code)) return {};
    const auto lead_byte = std::find_if(std::rbegin(kLeadBytes), std::rend(kLeadBytes),
                                        [&](const LeadByte& each) { return code >= each.min; });
    std::string text(lead_byte->bytes, '\0');
    for (std::size_t i = lead_byte->bytes - 1; i > 0; --i) {
        text[i] = static_cast<char>(0x80U | (code & 0x3fU));
        code >>= kContinuationBits;
    }
    text[0] = static_cast<char>(lead_byte->mark | code);
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
