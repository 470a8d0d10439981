#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace gsim::text {

/// Reads the decimal number at the beginning of [begin, end), rounded to the nearest double. std::from_chars
/// does the same, which libc++ has for double only since version 20. The result is that of std::from_chars,
/// and `value` is left alone if it is an error.
std::from_chars_result read_number(const char* begin, const char* end, double& value);

/// Returns the finite number that the complete text is, with or without a sign in front, or nothing if it is
/// not one.
std::optional<double> parse_number(std::string_view text);

}  // namespace gsim::text
