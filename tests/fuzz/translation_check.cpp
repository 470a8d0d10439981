#include "tests/fuzz/translation_check.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <lua.hpp>

#include "codegen/translate.h"

namespace gsim::fuzz {
namespace {

using codegen::TextTranslation;

struct LuaCloser {
    void operator()(lua_State* lua) const { lua_close(lua); }
};

TextTranslation translate(std::string_view gcode, const grammar::Dialect& dialect) {
    codegen::TranslateOptions options;
    options.dialect = &dialect;
    options.source_name = "fuzz.nc";
    return codegen::translate_text(gcode, options);
}

/// The last line counts whether or not a newline ends it.
std::ptrdiff_t line_count(std::string_view text) {
    const bool open_end = !text.empty() && text.back() != '\n';
    return std::count(text.begin(), text.end(), '\n') + (open_end ? 1 : 0);
}

std::optional<std::string> lua_error(const std::string& script) {
    const std::unique_ptr<lua_State, LuaCloser> lua(luaL_newstate());
    if (luaL_loadbufferx(lua.get(), script.data(), script.size(), "=part.lua", "t") == LUA_OK) return {};
    return lua_tostring(lua.get(), -1);
}

std::optional<std::string> broken_promise_in(const grammar::Dialect& dialect, std::string_view gcode) {
    const TextTranslation first = translate(gcode, dialect);
    const TextTranslation second = translate(gcode, dialect);
    if (first.ok != second.ok || first.lua != second.lua || first.diagnostics != second.diagnostics)
        return "two translations of one program differ";
    if (!first.ok) {
        if (first.diagnostics.empty()) return "the translation failed without a diagnostic";
        return {};
    }
    const std::ptrdiff_t expected = line_count(gcode) + 2;
    const bool may_end_early = dialect.rules().style == lexer::Style::rs274ngc;  // behind a second %
    const std::ptrdiff_t lines = line_count(first.lua);
    if (lines > expected || (lines < expected && !may_end_early))
        return fmt::format("{} lines of Lua where {} belong:\n{}", lines, expected, first.lua);
    if (const auto error = lua_error(first.lua))
        return fmt::format("Lua does not compile it: {}\n{}", *error, first.lua);
    return {};
}

}  // namespace

std::optional<std::string> broken_promise(std::string_view gcode) {
    for (const grammar::Dialect* dialect : {&grammar::dialect_ab9(), &grammar::dialect_rs274ngc()}) {
        if (const auto broken = broken_promise_in(*dialect, gcode))
            return fmt::format("{}: {}", dialect->name(), *broken);
    }
    return {};
}

}  // namespace gsim::fuzz
