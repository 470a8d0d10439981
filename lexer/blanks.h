#pragma once

#include <string>
#include <string_view>

namespace gsim::lexer {

/// A blank inside of a line.
constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// Nearly every word has none, so the one comparison that tells comes first.
inline bool has_blanks(std::string_view text) {
    for (const char c : text) {
        if (c <= ' ' && is_blank(c)) return true;
    }
    return false;
}

inline std::string remove_blanks(std::string_view text) {
    std::string kept;
    for (const char c : text) {
        if (!is_blank(c)) kept += c;
    }
    return kept;
}

}  // namespace gsim::lexer
