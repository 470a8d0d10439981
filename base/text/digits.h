#pragma once

namespace gsim::text {

/// True if c is an ASCII digit, independent of the locale.
constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

}  // namespace gsim::text
