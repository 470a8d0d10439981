#include "base/text/read_number.h"

#include <algorithm>
#include <cmath>
#include <system_error>

#include <fast_float/fast_float.h>

namespace gsim::text {

namespace {

/// True if a number has a digit other than 0 before its exponent; false for "inf" and "nan".
bool has_value(const char* begin, const char* end) {
    const char* const exponent = std::find_if(begin, end, [](char c) { return c == 'e' || c == 'E'; });
    return std::any_of(begin, exponent, [](char c) { return c >= '1' && c <= '9'; });
}

}  // namespace

std::from_chars_result read_number(const char* begin, const char* end, double& value) {
    double read = 0;
    const auto [parsed_end, error] = fast_float::from_chars(begin, end, read);
    if (error != std::errc()) return {parsed_end, error};
    // fast_float before version 4 returns too large numbers as infinite and too small ones as 0, without an
    // error.
    if ((read == 0 || !std::isfinite(read)) && has_value(begin, parsed_end))
        return {parsed_end, std::errc::result_out_of_range};
    value = read;
    return {parsed_end, std::errc()};
}

std::optional<double> parse_number(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = read_number(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

}  // namespace gsim::text
