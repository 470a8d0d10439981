#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/read_number.h"

namespace gsim::machine {

/// A word of a line of machine data: the text between blanks, tabs and the remark.
struct DataWord {
    std::string_view text;
    std::size_t column = 1;  ///< In bytes, from 1.
};

/// Returns the words of a line without its end. A remark begins with '#' or ';'.
std::vector<DataWord> data_words(std::string_view line);

/// True if a text can be one word of a line: not several words, no remark, no other line.
bool is_data_word(std::string_view text);

/// Returns the text in upper case, ASCII only.
std::string upper_case(std::string_view text);

/// Returns a word for messages: short, and without bytes that would upset a terminal.
std::string printable_word(std::string_view word);

/// Returns the shortest text that reads as the same number.
std::string number_text(double value);

/// Returns the number that the complete text is, or nothing if it is not one.
template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
    if constexpr (std::is_floating_point_v<Number>) {
        return text::parse_number(text);
    } else {
        if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
        Number value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
        return value;
    }
}

}  // namespace gsim::machine
