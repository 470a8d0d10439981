#pragma once

#include <string_view>

#include <fmt/format.h>

namespace gsim::text {

/// Returns the value rounded to 1e-9, never -0. Outputs show this value, so that they do not depend on the
/// last bits.
double rounded(double value);

/// Appends the text as it is.
inline void append_text(fmt::memory_buffer& out, std::string_view text) {
    out.append(text.data(), text.data() + text.size());
}

/// Appends rounded(value) in its shortest decimal form, such as 254 or 0.000000001; null if it is not finite.
void append_number(fmt::memory_buffer& out, double value);

/// Appends text as a JSON string with its quotes; bytes that are not UTF-8 become U+FFFD.
void append_json_string(fmt::memory_buffer& out, std::string_view text);

}  // namespace gsim::text
