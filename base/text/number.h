#pragma once

#include <string>
#include <string_view>

namespace gsim::text {

/// Returns the value, or 0 instead of -0. Used for all values that are printed with a number of significant
/// digits, because -0 carries no information.
constexpr double unsigned_zero(double value) {
    return value + 0.0;
}

/// Returns the digits of a number without exponent; those of -0 without their sign.
constexpr std::string_view unsigned_zero(std::string_view digits) {
    const bool zero = digits.find_first_not_of("-0.") == std::string_view::npos;
    return zero && digits.starts_with('-') ? digits.substr(1) : digits;
}

/// Returns the value with this number of digits after the point, 0 to 9. A value that they show as 0 has no
/// sign.
std::string fixed(double value, int decimals);

}  // namespace gsim::text
