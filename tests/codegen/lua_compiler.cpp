#include "tests/codegen/lua_compiler.h"

#include <memory>

#include <lua.hpp>

namespace gsim::codegen {

std::optional<std::string> compile_error(const std::string& script) {
    const std::unique_ptr<lua_State, void (*)(lua_State*)> lua(luaL_newstate(), lua_close);
    if (luaL_loadbufferx(lua.get(), script.data(), script.size(), "=part.lua", "t") == LUA_OK) return {};
    return lua_tostring(lua.get(), -1);
}

}  // namespace gsim::codegen
