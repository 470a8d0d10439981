#include "runtime/script/lua/object_names.h"

namespace gsim::script {

namespace {

/// Its address is the key of the table of numbers in the registry. The table maps objects, which it does not
/// keep alive, to their numbers. [1] has the last one.
char numbers_key = 0;

bool has_address(lua_State* state, int index) {
    switch (lua_type(state, index)) {
        case LUA_TTABLE:
        case LUA_TFUNCTION:
        case LUA_TUSERDATA:
        case LUA_TLIGHTUSERDATA:
        case LUA_TTHREAD: return true;
        default: return false;
    }
}

void push_numbers(lua_State* state) {
    if (lua_rawgetp(state, LUA_REGISTRYINDEX, &numbers_key) == LUA_TTABLE) return;
    lua_pop(state, 1);
    lua_newtable(state);
    lua_createtable(state, 0, 1);
    lua_pushliteral(state, "k");
    lua_setfield(state, -2, "__mode");
    lua_setmetatable(state, -2);
    lua_pushvalue(state, -1);
    lua_rawsetp(state, LUA_REGISTRYINDEX, &numbers_key);
}

lua_Integer object_number(lua_State* state, int index) {
    push_numbers(state);
    lua_pushvalue(state, index);
    if (lua_rawget(state, -2) == LUA_TNIL) {
        lua_rawgeti(state, -2, 1);
        const lua_Integer number = lua_tointeger(state, -1) + 1;
        lua_pop(state, 2);
        lua_pushinteger(state, number);
        lua_rawseti(state, -2, 1);
        lua_pushvalue(state, index);
        lua_pushinteger(state, number);
        lua_rawset(state, -3);
        lua_pushinteger(state, number);
    }
    const lua_Integer number = lua_tointeger(state, -1);
    lua_pop(state, 2);
    return number;
}

}  // namespace

std::string_view push_text(lua_State* state, int index) {
    const int at = lua_absindex(state, index);
    std::size_t size = 0;
    if (has_address(state, at) && luaL_getmetafield(state, at, "__tostring") == LUA_TNIL) {
        lua_pushfstring(state, "%s: %I", luaL_typename(state, at),
                        static_cast<LUAI_UACINT>(object_number(state, at)));
        const char* const text = lua_tolstring(state, -1, &size);
        return {text, size};
    }
    if (has_address(state, at)) lua_pop(state, 1);
    const char* const text = luaL_tolstring(state, at, &size);
    return {text, size};
}

}  // namespace gsim::script
