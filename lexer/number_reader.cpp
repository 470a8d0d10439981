#include "lexer/number_reader.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "lexer/blanks.h"
#include "lexer/signed_digits.h"

namespace gsim::lexer {

void NumberReader::fail_length(std::size_t characters) {
    errors_.fail(
        cursor_.column(), DiagnosticKind::number,
        fmt::format("the number has {} characters, at most {} are allowed", characters, kMaxNumberBytes));
}

Token NumberReader::number(std::string_view text, Value& value) {
    const bool has_gaps = has_blanks(text);
    const std::optional<Slice> slice = add(has_gaps ? remove_blanks(text) : text, false);
    if (!slice) return kBad;
    value.index = static_cast<std::uint32_t>(block_.numbers.size());
    block_.numbers.push_back(*slice);
    return kNumber;
}

Token NumberReader::variable(std::string_view text, Value& value) {
    const std::string digits = remove_blanks(text.substr(1));
    const std::size_t dot = std::min(digits.find('.'), digits.size());
    if (dot == 0 || digits.find_first_not_of('0', dot + 1) != std::string::npos) {
        errors_.fail(
            cursor_.column(), DiagnosticKind::number,
            fmt::format("the number of a variable must be an integer, not {}", digits.substr(0, 40)));
        return kBad;
    }
    const std::optional<std::uint32_t> number = parse_small_number(std::string_view(digits).substr(0, dot));
    if (!number) {
        errors_.fail(cursor_.column(), DiagnosticKind::number,
                     "the variable's number has more than 9 digits");
        return kBad;
    }
    value.index = *number;
    return kVariable;
}

Token NumberReader::sequence(std::string_view text, Value& value) {
    const std::string digits = remove_blanks(text.substr(1));
    const std::optional<std::uint32_t> number =
        parse_small_number(std::string_view(digits).substr(0, digits.find('.')));
    if (!number) {
        errors_.fail(cursor_.column(), DiagnosticKind::number, "the sequence number has more than 9 digits");
        return kBad;
    }
    value.index = *number;
    return kSequence;
}

Token NumberReader::skip(std::string_view text, Value& value) {
    const std::string_view digits = skip_blanks(text.substr(1));
    const std::uint32_t level = digits.empty() ? 1 : parse_small_number(digits).value_or(10);
    if (level < 1 || level > 9) {
        errors_.fail(cursor_.column(), DiagnosticKind::number,
                     fmt::format("block delete must be / or /1 to /9, not {}", text.substr(0, 20)));
        return kBad;
    }
    value.index = level;
    return kSkip;
}

}  // namespace gsim::lexer
