#include "tests/codegen/lua_compiler.h"

#include <memory>

#include <lua.hpp>

namespace gsim::codegen {
namespace {

std::unique_ptr<lua_State, void (*)(lua_State*)> new_state() {
    return {luaL_newstate(), lua_close};
}

int load(lua_State* lua, const std::string& script) {
    return luaL_loadbufferx(lua, script.data(), script.size(), "=part.lua", "t");
}

}  // namespace

std::optional<std::string> compile_error(const std::string& script) {
    const auto lua = new_state();
    if (load(lua.get(), script) == LUA_OK) return {};
    return lua_tostring(lua.get(), -1);
}

std::optional<double> run_number(const std::string& script) {
    const auto lua = new_state();
    if (load(lua.get(), script) != LUA_OK || lua_pcall(lua.get(), 0, 1, 0) != LUA_OK) return {};
    int is_number = 0;
    const double number = lua_tonumberx(lua.get(), -1, &is_number);
    return is_number != 0 ? std::optional(number) : std::nullopt;
}

}  // namespace gsim::codegen
