#pragma once

namespace gsim::text {

/// An ASCII digit, whatever the locale.
constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

}  // namespace gsim::text
