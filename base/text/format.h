#pragma once

#include <iterator>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace gsim::text {

/// Appends text formatted by fmt's rules. append_format() checks the format at compile time and calls this.
/// fmt::format_to() and fmt::join() instantiate the complete formatter, which takes a second and more of each
/// unit that has one.
void append_formatted(std::string& out, fmt::string_view format, fmt::format_args values);
void append_formatted(fmt::memory_buffer& out, fmt::string_view format, fmt::format_args values);

/// Appends formatted values to a std::string or a fmt::memory_buffer.
template <typename Out, typename... Values>
void append_format(Out& out, fmt::format_string<Values...> format, Values&&... values) {
    append_formatted(out, format, fmt::make_format_args(values...));
}

/// Returns the items of [first, last), each formatted by item_format, with the separator between them.
template <typename Iterator>
std::string joined(Iterator first, Iterator last, std::string_view separator,
                   fmt::string_view item_format = "{}") {
    std::string all;
    for (Iterator item = first; item != last; ++item) {
        if (item != first) all += separator;
        append_formatted(all, item_format, fmt::make_format_args(*item));
    }
    return all;
}

/// Returns all items of a range, each formatted by item_format, with the separator between them.
template <typename Range>
std::string joined(const Range& items, std::string_view separator, fmt::string_view item_format = "{}") {
    return joined(std::begin(items), std::end(items), separator, item_format);
}

/// Returns the items as a list for a message: "a", "a and b" or "a, b and c", with this conjunction.
template <typename Range>
std::string enumerated(const Range& items, std::string_view conjunction) {
    if (std::size(items) < 2) return joined(items, "");
    const auto last = std::prev(std::end(items));
    std::string list = joined(std::begin(items), last, ", ");
    list += ' ';
    list += conjunction;
    list += ' ';
    return list + joined(last, std::end(items), "");
}

}  // namespace gsim::text
