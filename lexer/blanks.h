#pragma once

#include <string>
#include <string_view>

namespace gsim::lexer {

/// Returns true for a blank inside of a line.
constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// Nearly every word has no blanks, so the one comparison that decides comes first.
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
