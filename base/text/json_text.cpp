#include "base/text/json_text.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "base/text/format.h"
#include "base/text/utf8.h"

namespace gsim::text {

namespace {

constexpr double kDecimalScale = 1e9;  // of the last digit shown

// Appends `units` billionths with at most 15 digits, for which removing zeros gives the shortest form.
void append_billionths(fmt::memory_buffer& out, std::int64_t units) {
    constexpr std::uint32_t kBillion = 1'000'000'000;
    if (units < 0) {
        out.push_back('-');
        units = -units;
    }
    const fmt::format_int integer_part(units / kBillion);
    append_text(out, {integer_part.data(), integer_part.size()});
    auto fraction = static_cast<std::uint32_t>(units % kBillion);
    if (fraction == 0) return;
    std::array<char, 10> text{'.'};
    for (std::size_t i = text.size() - 1; i > 0; --i, fraction /= 10) {
        text[i] = static_cast<char>('0' + fraction % 10);
    }
    std::string_view digits(text.data(), text.size());
    append_text(out, digits.substr(0, digits.find_last_not_of('0') + 1));
}

}  // namespace

double rounded(double value) {
    // Beyond 1e6 a double has no more than nine digits after the point anyway.
    if (!std::isfinite(value) || std::abs(value) >= 1e6) return value;
    return std::round(value * kDecimalScale) / kDecimalScale + 0.0;
}

void append_number(fmt::memory_buffer& out, double value) {
    if (!std::isfinite(value)) return append_text(out, "null");
    if (std::abs(value) < 1e6) return append_billionths(out, std::llround(value * kDecimalScale));
    text::append_format(out, "{}", value);
}

void append_json_string(fmt::memory_buffer& out, std::string_view text) {
    out.push_back('"');
    while (!text.empty()) {
        const std::size_t length = first_character(text).bytes;
        const char c = text[0];
        if (length == 0) {
            append_text(out, "\\ufffd");
        } else if (c == '"' || c == '\\') {
            out.push_back('\\');
            out.push_back(c);
        } else if (static_cast<unsigned char>(c) < 0x20) {
            text::append_format(out, "\\u{:04x}", static_cast<unsigned>(c));
        } else {
            append_text(out, text.substr(0, length));
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    out.push_back('"');
}

}  // namespace gsim::text
