#include "codegen/lua/lua_text.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/text/format.h"

namespace gsim::codegen {

namespace {

using std::string_view_literals::operator""sv;

constexpr std::array kKeywords = {
    "and"sv,      "break"sv,  "do"sv,   "else"sv, "elseif"sv, "end"sv,   "false"sv, "for"sv,
    "function"sv, "goto"sv,   "if"sv,   "in"sv,   "local"sv,  "nil"sv,   "not"sv,   "or"sv,
    "repeat"sv,   "return"sv, "then"sv, "true"sv, "until"sv,  "while"sv,
};

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

}  // namespace

bool is_lua_name(std::string_view name) {
    if (name.empty() || !is_letter(name.front())) return false;
    const auto is_allowed_char = [](char c) { return is_letter(c) || (c >= '0' && c <= '9'); };
    return std::all_of(name.begin(), name.end(), is_allowed_char) &&
           std::find(kKeywords.begin(), kKeywords.end(), name) == kKeywords.end();
}

void write_lua_string(std::string_view text, std::string& out) {
    out += '"';
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (c >= ' ' && c < 0x7f) {
            out += c;
        } else {
            text::append_format(out, "\\x{:02X}", static_cast<unsigned char>(c));
        }
    }
    out += '"';
}

}  // namespace gsim::codegen
