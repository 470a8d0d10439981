#include "tests/conformance/canon_call.h"

#include <algorithm>
#include <charconv>

namespace gsim::conformance {

namespace {

constexpr std::string_view kWhitespace = " \t";
constexpr std::string_view kSeparators = ", \t";

std::string_view without_word(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(kWhitespace), text.size());
    text.remove_prefix(begin);
    text.remove_prefix(std::min(text.find_first_of(kWhitespace), text.size()));
    text.remove_prefix(std::min(text.find_first_not_of(kWhitespace), text.size()));
    return text;
}

bool is_name(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
}

}  // namespace

std::vector<double> CanonCall::numbers() const {
    std::vector<double> values;
    std::string_view remainder = arguments;
    while (true) {
        remainder.remove_prefix(std::min(remainder.find_first_not_of(kSeparators), remainder.size()));
        if (remainder.empty()) return values;
        const std::string_view word = remainder.substr(0, remainder.find_first_of(kSeparators));
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error == std::errc() && end == word.data() + word.size()) values.push_back(value);
        remainder.remove_prefix(word.size());
    }
}

std::optional<CanonCall> read_canon_call(std::string_view line) {
    const std::string_view call = without_word(without_word(line));  // the number and the N word
    const std::size_t open = call.find('(');
    const std::size_t close = call.rfind(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
        return std::nullopt;
    if (!is_name(call.substr(0, open))) return std::nullopt;
    return CanonCall{call.substr(0, open), call.substr(open + 1, close - open - 1)};
}

}  // namespace gsim::conformance
