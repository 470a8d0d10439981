#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lexer/blanks.h"

namespace gsim::lexer {

/// Returns the text without its leading blanks.
inline std::string_view skip_blanks(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    return text;
}

/// Sign and digits of `[blanks][sign][blanks]digits`.
struct SignedDigits {
    bool negative = false;
    std::string_view digits;
};

/// Returns the parts of a number.
inline SignedDigits split_sign(std::string_view text) {
    text = skip_blanks(text);
    SignedDigits result;
    if (!text.empty() && (text.front() == '+' || text.front() == '-')) {
        result.negative = text.front() == '-';
        text = skip_blanks(text.substr(1));
    }
    result.digits = text;
    return result;
}

/// Returns a number of at most 9 digits, leading zeros not counted; no value if it has more.
inline std::optional<std::uint32_t> parse_small_number(std::string_view digits) {
    while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
    if (digits.size() > 9) return std::nullopt;
    std::uint32_t value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

}  // namespace gsim::lexer
