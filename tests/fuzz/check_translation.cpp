#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <lua.hpp>

#include "codegen/translate.h"
#include "tests/fuzz/checks.h"

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

Outcome check_in(const grammar::Dialect& dialect, std::string_view gcode) {
    const TextTranslation first = translate(gcode, dialect);
    const TextTranslation second = translate(gcode, dialect);
    if (first.ok != second.ok || first.lua != second.lua || first.diagnostics != second.diagnostics)
        return broken("two translations of one program differ");
    if (!first.ok) {
        if (first.diagnostics.empty()) return broken("the translation failed without a diagnostic");
        return rejected();
    }
    const std::ptrdiff_t expected = line_count(gcode) + 2;
    const bool may_end_early = dialect.text().tape_marks_end_program;
    const std::ptrdiff_t lines = line_count(first.lua);
    if (lines > expected || (lines < expected && !may_end_early))
        return broken(fmt::format("{} lines of Lua where {} belong:\n{}", lines, expected, first.lua));
    if (const auto error = lua_error(first.lua))
        return broken(fmt::format("Lua does not compile it: {}\n{}", *error, first.lua));
    return accepted();
}

}  // namespace

Outcome check_translate_ab9(std::string_view gcode) {
    return check_in(grammar::dialect_ab9(), gcode);
}

Outcome check_translate_rs274ngc(std::string_view gcode) {
    return check_in(grammar::dialect_rs274ngc(), gcode);
}

}  // namespace gsim::fuzz
