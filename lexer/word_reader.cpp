#include "lexer/word_reader.h"

#include <string>

#include <fmt/format.h>

#include "lexer/blanks.h"
#include "lexer/signed_digits.h"

namespace gsim::lexer {

namespace {

char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

/// Returns ten times the number of a code with at most four digits and one decimal, such as 921 for "92.1";
/// else -1.
std::int32_t code_x10(const SignedDigits& number) {
    if (number.negative) return -1;
    const std::size_t dot = number.digits.find('.');
    std::string_view integer_part = number.digits.substr(0, dot);
    std::string_view part = dot == std::string_view::npos ? "" : number.digits.substr(dot + 1);
    while (part.size() > 1 && part.back() == '0') part.remove_suffix(1);
    while (integer_part.size() > 1 && integer_part.front() == '0') integer_part.remove_prefix(1);
    if (integer_part.size() > 4 || part.size() > 1) return -1;
    std::int32_t code = 0;
    for (const char c : integer_part) code = code * 10 + (c - '0');
    return code * 10 + (part.empty() ? 0 : part[0] - '0');
}

Address comma_address(char letter) {
    switch (upper(letter)) {
        case 'C': return kChamfer;
        case 'R': return kCornerRadius;
        default: return kLineAngle;
    }
}

}  // namespace

Token WordReader::word_token(const Word& word) const {
    if (is_axis_letter(word.address)) return kAxis;
    if (!rules_.ambiguous_words) return word.address == 'X' || word.address == 'U' ? kAxis : kOther;
    switch (word.address) {
        case 'U':
        case 'X': return kAxisOrTime;
        case 'P': return kP;
        case 'G': return word.code_x10 == 40 ? kDwell : kOther;
        case 'M': return word.code_x10 == 980 || word.code_x10 == 990 ? kCall : kOther;
        default: return kOther;
    }
}

Token WordReader::add(const Word& word, Value& value) {
    if (block_.words.size() == kMaxWords) {
        errors_.exceed(cursor_.column(), DiagnosticKind::too_large,
                       fmt::format("the block has more than {} words", kMaxWords));
        return kEob;
    }
    value.index = static_cast<std::uint32_t>(block_.words.size());
    block_.words.push_back(word);
    const Token token = word_token(word);
    saw_dwell_ |= token == kDwell;
    return token;
}

Token WordReader::word(std::string_view text, Value& value) {
    Word word;
    word.address = static_cast<Address>(upper(text[0]));
    word.column = cursor_.column();
    const bool has_gaps = rules_.blanks_within_words && has_blanks(text);
    const std::string without_gaps = has_gaps ? remove_blanks(text) : std::string();
    const SignedDigits number = split_sign((has_gaps ? std::string_view(without_gaps) : text).substr(1));
    const std::optional<Slice> slice = numbers_.add(number.digits, number.negative);
    if (!slice) return kBad;
    word.number = *slice;
    if (word.address == 'G' || word.address == 'M') word.code_x10 = code_x10(number);
    return add(word, value);
}

Token WordReader::named_word(Address address, std::string_view text, Value& value) {
    Word word;
    word.address = address;
    word.column = cursor_.column();
    const std::size_t mark = text.find('=');
    const std::size_t value_begin = mark == std::string_view::npos ? text.find_first_of("CcRrAa") : mark;
    const SignedDigits number = split_sign(text.substr(value_begin + 1));
    const std::optional<Slice> slice = numbers_.add(number.digits, number.negative);
    if (!slice) return kBad;
    word.number = *slice;
    return add(word, value);
}

Token WordReader::comma_word(std::string_view text, Value& value) {
    return named_word(comma_address(text[text.find_first_of("CcRrAa")]), text, value);
}

Token WordReader::comma_letter(std::string_view text, Value& value) {
    return open_word(comma_address(text.back()), value);
}

Token WordReader::open_word(Address address, Value& value) {
    Word word;
    word.address = address;
    word.column = cursor_.column();
    open_word_ = block_.words.size();
    switch (add(word, value)) {
        case kAxis: return kAxisLetter;
        case kAxisOrTime: return kAxisOrTimeLetter;
        case kP: return kPLetter;
        case kEob: return kEob;
        default: return kOtherLetter;
    }
}

Token WordReader::letter(char c, Value& value) {
    return open_word(static_cast<Address>(upper(c)), value);
}

Token WordReader::intermediate_point(Value& value) {
    Word word;
    word.address = kIntermediatePoint;
    word.column = cursor_.column();
    return add(word, value);
}

}  // namespace gsim::lexer
