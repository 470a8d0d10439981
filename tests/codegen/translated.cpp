#include "tests/codegen/translated.h"

#include <algorithm>

namespace gsim::codegen {

std::string Translated::code(std::size_t line) const {
    std::size_t begin = 0;
    for (; line > 0; --line) begin = lua.find('\n', begin) + 1;
    std::string_view text = std::string_view(lua).substr(begin);
    text = text.substr(0, text.find('\n'));
    text = text.substr(0, text.find("-- "));
    const std::size_t last = text.find_last_not_of(' ');
    return std::string(text.substr(0, last == std::string_view::npos ? 0 : last + 1));
}

Translated translated(std::string_view gcode, const TranslateOptions& options) {
    constexpr std::string_view kName = "part.nc:";
    TextTranslation result = translate_text(gcode, options);
    Translated out{result.ok, std::move(result.lua), {}};
    std::string_view remainder = result.diagnostics;
    while (!remainder.empty()) {
        const std::string_view line = remainder.substr(0, remainder.find('\n'));
        if (line.starts_with(kName)) out.messages.append(line.substr(kName.size())).append("\n");
        remainder.remove_prefix(std::min(remainder.size(), line.size() + 1));
    }
    return out;
}

Translated translated_ngc(std::string_view gcode, TranslateOptions options) {
    options.dialect = &grammar::dialect_rs274ngc();
    return translated(gcode, options);
}

namespace {

std::string first_line(const Translated& result) {
    return result.ok ? result.code(1) : result.messages;
}

}  // namespace

std::string lua_of(std::string_view block) {
    return first_line(translated(block));
}

std::string ngc_lua_of(std::string_view block) {
    return first_line(translated_ngc(block));
}

}  // namespace gsim::codegen
