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

TextTranslation translate(std::string_view gcode) {
    codegen::TranslateOptions options;
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

}  // namespace

std::optional<std::string> broken_promise(std::string_view gcode) {
    const TextTranslation first = translate(gcode);
    const TextTranslation second = translate(gcode);
    if (first.ok != second.ok || first.lua != second.lua || first.diagnostics != second.diagnostics)
        return "two translations of one program differ";
    if (!first.ok) {
        if (first.diagnostics.empty()) return "the translation failed without a diagnostic";
        return {};
    }
    const std::ptrdiff_t expected = line_count(gcode) + 2;
    if (const std::ptrdiff_t lines = line_count(first.lua); lines != expected)
        return fmt::format("{} lines of Lua where {} belong:\n{}", lines, expected, first.lua);
    if (const auto error = lua_error(first.lua))
        return fmt::format("Lua does not compile it: {}\n{}", *error, first.lua);
    return {};
}

}  // namespace gsim::fuzz
