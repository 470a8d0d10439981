// Actions of the rules of gcode.l on names: O-words and parameters of RS274/NGC, functions and operators,
// statements that print.

#include <algorithm>

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "lexer/alias.h"
#include "lexer/blanks.h"
#include "lexer/lexer.h"
#include "lexer/names.h"

namespace gsim::lexer {

/// Adds a name of RS274/NGC without its first character, `100` or `<a name>`: blanks and case have no
/// meaning.
Slice Lexer::add_name(std::string_view text) {
    std::string name;
    for (const char c : text) {
        if (c == '<' || c == '>' || c == ' ' || c == '\t') continue;
        name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return block_.add(name);
}

/// Zeros before a number do not change it. A name in < > is used as written, so o<02> is not o2.
Slice Lexer::strip_leading_zeros(Slice name) const {
    if (block_.view(name).find_first_not_of("0123456789") != std::string_view::npos) return name;
    while (name.size > 1 && block_.text[name.begin] == '0') {
        ++name.begin;
        --name.size;
    }
    return name;
}

Token Lexer::flow_name(std::string_view text, Value&) {
    expression_to_end_ = true;
    block_.structural = true;
    const Slice name = add_name(text.substr(1));
    block_.program = text.ends_with('>') ? name : strip_leading_zeros(name);
    if (block_.program.size > 0) return kFlowName;
    fail(token_column_, DiagnosticKind::syntax, "the name of an O-word is empty");
    return kBad;
}

Token Lexer::flow_expression() {
    expression_to_end_ = true;
    return kFlowLetter;
}

Token Lexer::named_variable(std::string_view text, Value& value) {
    if (!is_ngc()) return unknown("<");
    const Slice name = add_name(text.substr(1));
    if (name.size == 0) {
        fail(token_column_, DiagnosticKind::syntax, "the name of a parameter is empty");
        return kBad;
    }
    value.index = static_cast<std::uint32_t>(block_.numbers.size());
    block_.numbers.push_back(name);
    return kNamedVariable;
}

Token Lexer::unterminated_name() {
    if (!is_ngc()) return unknown("<");
    fail(token_column_, DiagnosticKind::syntax, "the name has no '>' behind it, or more than 100 characters");
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

Token Lexer::expression_name(std::string_view text, std::size_t& kept, Value& value) {
    const std::string name = text::upper(remove_blanks(text));
    const NameStyle other = is_ngc() ? NameStyle::ab9 : NameStyle::rs274ngc;
    const bool may_be_joined = is_ngc() && brackets_ > 0;
    const auto* found_entry =
        std::find_if(kExpressionNames.begin(), kExpressionNames.end(), [&](const ExpressionName& t) {
            return t.style != other && (t.name == name || (may_be_joined && name.starts_with(t.name)));
        });
    if (found_entry != kExpressionNames.end()) {
        kept = length_with_blanks(text, found_entry->name.size());
        value.index = static_cast<std::uint32_t>(found_entry->op);
        return is_ngc() && found_entry->token == kRelation ? kComparison : found_entry->token;
    }
    if (is_ngc() && brackets_ == 0) {
        const auto* flow = std::find_if(kFlowNames.begin(), kFlowNames.end(),
                                        [&](const FlowName& f) { return f.name == name; });
        if (flow != kFlowNames.end()) {
            value.index = static_cast<std::uint32_t>(flow->flow);
            return kFlow;
        }
    }
    const std::size_t blank = text.find_first_of(" \t");
    if (blank != std::string_view::npos) {  // joined they are no name
        kept = blank;
        return expression_name(text.substr(0, blank), kept, value);
    }
    return fail_name(text);
}

/// Reports the text at the position of an expected name of an expression, or keyword after an O-word.
Token Lexer::fail_name(std::string_view text) {
    const std::string name = text::upper(text);
    if (!is_ngc() && brackets_ == 0 && name.size() == 1) {
        fail(token_column_, DiagnosticKind::code_conflict,
             fmt::format("the word {} stands in the same block as an assignment; give it a block of its own",
                         name));
        return kBad;
    }
    const NameStyle other = is_ngc() ? NameStyle::ab9 : NameStyle::rs274ngc;
    std::vector<std::string> names;
    const bool flow_expected = is_ngc() && brackets_ == 0;
    if (flow_expected) {
        for (const FlowName& flow : kFlowNames) names.emplace_back(flow.name);
    } else {
        for (const ExpressionName& t : kExpressionNames) {
            if (t.style != other) names.emplace_back(t.name);
        }
    }
    const std::string nearest = nearest_name(name, names);
    fail(token_column_, DiagnosticKind::syntax,
         fmt::format("'{}' is no {}{}", text.substr(0, 40),
                     flow_expected ? "keyword behind an O-word" : "function or operator of an expression",
                     nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)));
    return kBad;
}

Token Lexer::power(Value& value) {
    if (!is_ngc()) {
        fail(token_column_, DiagnosticKind::syntax,
             "'**' is no operator of the 9/Series; a power is EXP[#2*LN[#1]], or a product");
        return kBad;
    }
    value.index = static_cast<std::uint32_t>(Operator::power);
    return kPower;
}

Token Lexer::print_text(std::string_view text, Value& value) {
    constexpr std::size_t kMaxPrinted = 400;
    const std::size_t begin = text.find('[') + 1;
    if (text.rfind(']') - begin > kMaxPrinted) {
        fail(token_column_, DiagnosticKind::too_large,
             fmt::format("DPRNT takes at most {} characters", kMaxPrinted));
        return kBad;
    }
    block_.print = block_.add(text.substr(begin, text.rfind(']') - begin));
    value.index = static_cast<std::uint32_t>(Print::text);
    return kPrint;
}

Token Lexer::print_switch(std::string_view name, Value& value) {
    value.index = static_cast<std::uint32_t>(name == "POPEN" ? Print::open : Print::close);
    return kPrint;
}

}  // namespace gsim::lexer
