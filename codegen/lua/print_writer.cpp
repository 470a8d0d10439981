#include "codegen/lua/print_writer.h"

#include <string_view>

#include <fmt/format.h>

#include "base/text/digits.h"
#include "codegen/lua/lua_text.h"

namespace gsim::codegen {

namespace {

constexpr std::size_t kMaxVariableDigits = 5;

/// Value in the text: `#100[53]`.
struct Value {
    std::string_view variable;
    char decimals;
    std::size_t size;  ///< Total size.
};

std::optional<Value> value_at(std::string_view text) {
    std::size_t end = 1;
    while (end < text.size() && text::is_digit(text[end])) ++end;
    const bool has_format = end > 1 && end - 1 <= kMaxVariableDigits && end + 3 < text.size() &&
                            text[end] == '[' && text::is_digit(text[end + 1]) &&
                            text::is_digit(text[end + 2]) && text[end + 3] == ']';
    if (!has_format) return std::nullopt;
    return Value{text.substr(1, end - 1), text[end + 2], end + 4};
}

}  // namespace

Result<void> write_print(const grammar::Block& block, std::string& out) {
    if (block.print != lexer::Print::text) {
        out += block.print == lexer::Print::open ? "POPEN() " : "PCLOS() ";
        return {};
    }
    std::string format;
    std::string values;
    std::string_view text = block.text->view(block.text->print);
    while (!text.empty()) {
        if (text[0] != '#') {
            if (text[0] == '%') format += '%';
            format += text[0] == '*' ? ' ' : text[0];
            text.remove_prefix(1);
            continue;
        }
        const std::optional<Value> value = value_at(text);
        if (!value) {
            return Unexpected(
                "DPRNT requires the digits before and after the decimal point in brackets after a variable, "
                "as in #100[53]");
        }
        format += fmt::format("%.{}f", value->decimals);
        values += fmt::format(", v[{}]", value->variable);
        text.remove_prefix(value->size);
    }
    out += "DPRNT(";
    write_lua_string(format, out);
    out += values;
    out += ") ";
    return {};
}

}  // namespace gsim::codegen
