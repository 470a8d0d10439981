// What the rules of gcode.l do with names: O-words and parameters of RS274/NGC, statements that print.

#include <fmt/format.h>

#include "lexer/alias.h"
#include "lexer/lexer.h"

namespace gsim::lexer {

/// A name of RS274/NGC behind its first character, `100` or `<a name>`: blanks and case mean nothing.
Slice Lexer::add_name(std::string_view text) {
    std::string name;
    for (const char c : text) {
        if (c == '<' || c == '>' || c == ' ' || c == '\t') continue;
        name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return block_.add(name);
}

/// A number is the same with zeros before it.
Slice Lexer::without_zeros(Slice name) const {
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
    block_.program = without_zeros(add_name(text.substr(1)));
    if (block_.program.size > 0) return kFlowName;
    fail(token_column_, "the name of an O-word is empty");
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
        fail(token_column_, "the name of a parameter is empty");
        return kBad;
    }
    value.index = static_cast<std::uint32_t>(block_.numbers.size());
    block_.numbers.push_back(name);
    return kNamedVariable;
}

Token Lexer::endless_name() {
    if (!is_ngc()) return unknown("<");
    fail(token_column_, "the name has no '>' behind it, or more than 100 characters");
    return kBad;
}

Token Lexer::power(Value& value) {
    if (!is_ngc()) {
        fail(token_column_, "'**' is no operator of the 9/Series; a power is EXP[#2*LN[#1]], or a product");
        return kBad;
    }
    value.index = static_cast<std::uint32_t>(Operator::power);
    return kPower;
}

Token Lexer::print_text(std::string_view text, Value& value) {
    constexpr std::size_t kMaxPrinted = 400;
    const std::size_t begin = text.find('[') + 1;
    if (text.rfind(']') - begin > kMaxPrinted) {
        fail(token_column_, fmt::format("DPRNT takes at most {} characters", kMaxPrinted));
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
