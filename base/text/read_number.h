#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace gsim::text {

/// Reads the decimal number that [begin, end) begins with, rounded to the nearest double: what
/// std::from_chars does, which libc++ has for double since version 20 only. The answer is that of
/// std::from_chars, and `value` is left alone where it is an error.
std::from_chars_result read_number(const char* begin, const char* end, double& value);

/// The finite number that the whole text is, with or without a sign in front; nothing where it is none.
std::optional<double> number_of(std::string_view text);

}  // namespace gsim::text
