#pragma once

#include <string>
#include <string_view>

namespace gsim::text {

/// The value, 0 in place of -0. What is printed with a number of significant digits comes through here: -0
/// tells nobody anything.
constexpr double unsigned_zero(double value) {
    return value + 0.0;
}

/// The digits of a number without exponent; those of -0 without their sign.
constexpr std::string_view unsigned_zero(std::string_view digits) {
    const bool zero = digits.find_first_not_of("-0.") == std::string_view::npos;
    return zero && digits.starts_with('-') ? digits.substr(1) : digits;
}

/// The value with so many digits behind the point, 0 to 9; what these show as 0 has no sign.
std::string fixed(double value, int decimals);

}  // namespace gsim::text
