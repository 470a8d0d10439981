#include "lexer/name_reader.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "lexer/alias.h"
#include "lexer/blanks.h"
#include "lexer/names.h"
#include "lexer/signed_digits.h"

namespace gsim::lexer {

Token reject_character(char character, BlockErrors& errors, const TextCursor& cursor) {
    if (character == ')') {
        errors.fail(cursor.column(), DiagnosticKind::syntax,
                    "')' without '('; a comment ends at its first ')', even if it contains another '('");
        return kBad;
    }
    const bool visible = character > ' ' && character < 0x7f;
    errors.fail(cursor.column(), DiagnosticKind::character,
                visible ? fmt::format("unexpected character '{}'", character)
                        : fmt::format("unexpected byte 0x{:02X}", static_cast<unsigned char>(character)));
    return kBad;
}

Token NameReader::program(std::string_view text) {
    const std::string_view name = skip_blanks(text);
    if (name.size() > 32) {
        errors_.fail(cursor_.column(), DiagnosticKind::too_large,
                     "the program name has more than 32 characters");
        return kBad;
    }
    block_.program = block_.add(name);
    return kProgram;
}

/// Adds a name of RS274/NGC without its first character, `100` or `<a name>`: blanks and case have no
/// meaning.
Slice NameReader::add(std::string_view text) {
    std::string name;
    for (const char c : text) {
        if (c == '<' || c == '>' || c == ' ' || c == '\t') continue;
        name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return block_.add(name);
}

/// Zeros before a number do not change it. A name in < > is used as written, so o<02> is not o2.
Slice NameReader::strip_leading_zeros(Slice name) const {
    if (block_.view(name).find_first_not_of("0123456789") != std::string_view::npos) return name;
    while (name.size > 1 && block_.text[name.begin] == '0') {
        ++name.begin;
        --name.size;
    }
    return name;
}

Token NameReader::flow_name(std::string_view text) {
    nesting_.extend_to_block_end();
    block_.structural = true;
    const Slice name = add(text.substr(1));
    block_.program = text.ends_with('>') ? name : strip_leading_zeros(name);
    if (block_.program.size > 0) return kFlowName;
    errors_.fail(cursor_.column(), DiagnosticKind::syntax, "the name of an O-word is empty");
    return kBad;
}

Token NameReader::flow_expression() {
    nesting_.extend_to_block_end();
    return kFlowLetter;
}

Token NameReader::variable(std::string_view text, Value& value) {
    if (!rules_.names_in_angle_brackets) return reject_character('<', errors_, cursor_);
    const Slice name = add(text.substr(1));
    if (name.size == 0) {
        errors_.fail(cursor_.column(), DiagnosticKind::syntax, "the name of a parameter is empty");
        return kBad;
    }
    value.index = static_cast<std::uint32_t>(block_.numbers.size());
    block_.numbers.push_back(name);
    return kNamedVariable;
}

Token NameReader::unterminated() {
    if (!rules_.names_in_angle_brackets) return reject_character('<', errors_, cursor_);
    errors_.fail(cursor_.column(), DiagnosticKind::syntax,
                 "the name has no '>' after it, or more than 100 characters");
    return kBad;
}

namespace {

/// Returns the length of the start of `text` that has so many characters, blanks not counted.
std::size_t length_with_blanks(std::string_view text, std::size_t characters) {
    std::size_t length = 0;
    for (; characters > 0; ++length) {
        if (!is_blank(text[length])) --characters;
    }
    return length;
}

}  // namespace

Token NameReader::of_expression(std::string_view text, std::size_t& kept, Value& value) {
    const std::string name = text::upper(remove_blanks(text));
    const bool may_be_joined = rules_.blanks_within_words && nesting_.in_brackets();
    const auto expression_name = std::find_if(
        rules_.expression_names.begin(), rules_.expression_names.end(), [&](const ExpressionName& one) {
            return one.name == name || (may_be_joined && name.starts_with(one.name));
        });
    if (expression_name != rules_.expression_names.end()) {
        kept = length_with_blanks(text, expression_name->name.size());
        value.index = static_cast<std::uint32_t>(expression_name->op);
        const bool chained = rules_.chained_comparisons && expression_name->token == kRelation;
        return chained ? kComparison : expression_name->token;
    }
    if (rules_.has_o_words && !nesting_.in_brackets()) {
        const auto* flow = std::find_if(kFlowNames.begin(), kFlowNames.end(),
                                        [&](const FlowName& one) { return one.name == name; });
        if (flow != kFlowNames.end()) {
            value.index = static_cast<std::uint32_t>(flow->flow);
            return kFlow;
        }
    }
    const std::size_t blank = text.find_first_of(" \t");
    if (blank != std::string_view::npos) {  // joined they are no name
        kept = blank;
        return of_expression(text.substr(0, blank), kept, value);
    }
    return reject(text);
}

/// Reports the text at the position of an expected name of an expression, or keyword of an O-word.
Token NameReader::reject(std::string_view text) {
    const std::string name = text::upper(text);
    if (rules_.separate_assignments && !nesting_.in_brackets() && name.size() == 1) {
        errors_.fail(
            cursor_.column(), DiagnosticKind::code_conflict,
            fmt::format("the word {} is in the same block as an assignment; move it to a separate block",
                        name));
        return kBad;
    }
    std::vector<std::string> names;
    const bool flow_expected = rules_.has_o_words && !nesting_.in_brackets();
    if (flow_expected) {
        for (const FlowName& flow : kFlowNames) names.emplace_back(flow.name);
    } else {
        for (const ExpressionName& one : rules_.expression_names) names.emplace_back(one.name);
    }
    const std::string nearest = nearest_name(name, names);
    errors_.fail(
        cursor_.column(), DiagnosticKind::syntax,
        fmt::format("'{}' is not a {}{}", text.substr(0, 40),
                    flow_expected ? "keyword after an O-word" : "function or operator of an expression",
                    nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)));
    return kBad;
}

Token NameReader::power(Value& value) {
    if (!rules_.has_power_operator) {
        errors_.fail(
            cursor_.column(), DiagnosticKind::syntax,
            fmt::format("'**' is not an operator of {}; use EXP[#2*LN[#1]] for a power, or a product",
                        rules_.controller));
        return kBad;
    }
    value.index = static_cast<std::uint32_t>(Operator::power);
    return kPower;
}

}  // namespace gsim::lexer
