#include "lexer/alias.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include <fmt/format.h>

#include "base/text/digits.h"
#include "base/text/letter_case.h"
#include "base/text/read_number.h"

namespace gsim::lexer {

namespace {

bool is_letter(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

bool is_name(std::string_view text) {
    return text.size() >= 2 && is_letter(text[0]) && !text::is_digit(text[1]) &&
           std::all_of(text.begin(), text.end(),
                       [](char c) { return is_letter(c) || text::is_digit(c) || c == '_'; });
}

bool is_number(std::string_view text) {
    const auto dots = std::count(text.begin(), text.end(), '.');
    return !text.empty() && text.size() <= 16 && dots <= 1 && text::is_digit(text[0]) &&
           std::all_of(text.begin(), text.end(), [](char c) { return text::is_digit(c) || c == '.'; });
}

}  // namespace

std::optional<std::string> Aliases::add(std::string_view name, std::string_view word) {
    if (!is_name(name)) {
        return fmt::format(
            "'{}' is not a valid name of an alias: it must begin with at least two letters, then letters, "
            "digits and '_'",
            name);
    }
    if (word.empty() || !is_letter(word[0]) || !is_number(word.substr(1))) {
        return fmt::format(
            "'{}' is not a valid word for an alias: it must be one letter and a number, such as M08", word);
    }
    const auto [found_entry, is_new] = words_.try_emplace(
        text::upper(name), Word{text::upper(word.substr(0, 1))[0], std::string(word.substr(1))});
    if (!is_new) return fmt::format("the alias '{}' is given twice", name);
    return std::nullopt;
}

const Aliases::Word* Aliases::find(std::string_view name) const {
    const auto found_entry = words_.find(text::upper(name));
    return found_entry == words_.end() ? nullptr : &found_entry->second;
}

bool Aliases::has_alias_of(char letter, int number) const {
    return std::any_of(words_.begin(), words_.end(), [&](const auto& entry) {
        return entry.second.letter == letter && text::parse_number(entry.second.number) == number;
    });
}

std::string Aliases::nearest(std::string_view name) const {
    std::vector<std::string> names;
    for (const auto& entry : words_) names.push_back(entry.first);
    return nearest_name(text::upper(name), names);
}

}  // namespace gsim::lexer
