#include "runtime/script/lua/sandbox.h"

#include <array>

#include "runtime/script/lua/key_order.h"
#include "runtime/script/lua/lua_state.h"
#include "runtime/script/lua/table_functions.h"
#include "runtime/script/lua/text_functions.h"

namespace gsim::script {

namespace {

constexpr lua_Integer kRandomSeed = 2001;  // runs are repeatable

template <std::size_t Count>
void copy_fields(lua_State* state, const char* library, const std::array<const char*, Count>& names) {
    lua_newtable(state);
    lua_getglobal(state, library);
    for (const char* name : names) {
        lua_getfield(state, -1, name);
        lua_setfield(state, -3, name);
    }
    lua_pop(state, 1);
    lua_setfield(state, -2, library);
}

/// Ends a pcall; `status` is LUA_YIELD if the function has waited for other processes.
int finish_pcall(lua_State* state, int status, lua_KContext) {
    const bool done = status == LUA_OK || status == LUA_YIELD;
    if (!done) LuaState::stop_if_out_of_memory(state, status);
    lua_pushboolean(state, static_cast<int>(done));
    lua_insert(state, 1);
    return lua_gettop(state);
}

int safe_pcall(lua_State* state) {
    luaL_checkany(state, 1);
    const int status = lua_pcallk(state, lua_gettop(state) - 1, LUA_MULTRET, 0, 0, finish_pcall);
    return finish_pcall(state, status, 0);
}

/// Returns the value of an operand of vacant arithmetic: nil counts as 0.
lua_Number number_or_zero(lua_State* state, int index) {
    return lua_isnil(state, index) ? 0.0 : luaL_checknumber(state, index);
}

template <int Operator>
int vacant_arithmetic(lua_State* state) {
    lua_pushnumber(state, number_or_zero(state, 1));
    lua_pushnumber(state, number_or_zero(state, 2));
    lua_arith(state, Operator);
    return 1;
}

int vacant_minus(lua_State* state) {
    lua_pushnumber(state, -number_or_zero(state, 1));
    return 1;
}

int vacant_less(lua_State* state) {
    lua_pushboolean(state, static_cast<int>(number_or_zero(state, 1) < number_or_zero(state, 2)));
    return 1;
}

int vacant_less_equal(lua_State* state) {
    lua_pushboolean(state, static_cast<int>(number_or_zero(state, 1) <= number_or_zero(state, 2)));
    return 1;
}

constexpr std::array kBase = {"assert", "error", "ipairs", "select", "tonumber", "type"};
constexpr std::array kMath = {"abs",  "acos",       "asin",      "atan", "ceil", "cos",    "deg",
                              "exp",  "floor",      "fmod",      "huge", "log",  "max",    "maxinteger",
                              "min",  "mininteger", "modf",      "pi",   "rad",  "random", "sin",
                              "sqrt", "tan",        "tointeger", "type", "ult"};
constexpr std::array kString = {"byte", "char", "format", "len", "lower", "rep", "reverse", "sub", "upper"};
constexpr std::array kTable = {"concat", "insert", "pack", "remove", "sort", "unpack"};

/// ("x"):upper() finds methods in the metatable of strings. It gets the safe ones, in a table that no script
/// can change.
void set_string_methods(lua_State* state) {
    lua_pushliteral(state, "");
    if (lua_getmetatable(state, -1) != 0) {
        lua_getfield(state, -3, "string");
        lua_newtable(state);
        lua_pushnil(state);
        while (lua_next(state, -3) != 0) {
            lua_pushvalue(state, -2);
            lua_insert(state, -2);
            lua_rawset(state, -4);
        }
        lua_remove(state, -2);
        lua_setfield(state, -2, "__index");
        lua_pop(state, 1);
    }
    lua_pop(state, 1);
}

void open_libraries(lua_State* state) {
    luaL_requiref(state, LUA_GNAME, luaopen_base, 1);
    luaL_requiref(state, LUA_MATHLIBNAME, luaopen_math, 1);
    luaL_requiref(state, LUA_STRLIBNAME, luaopen_string, 1);
    luaL_requiref(state, LUA_TABLIBNAME, luaopen_table, 1);
    lua_pop(state, 4);
}

void seed_random(lua_State* state) {
    lua_getglobal(state, "math");
    lua_getfield(state, -1, "randomseed");
    lua_pushinteger(state, kRandomSeed);
    lua_call(state, 1, 0);
    lua_pop(state, 1);
}

}  // namespace

void push_safe_library(lua_State* state) {
    open_libraries(state);
    seed_random(state);
    lua_newtable(state);
    for (const char* name : kBase) {
        lua_getglobal(state, name);
        lua_setfield(state, -2, name);
    }
    copy_fields(state, "math", kMath);
    copy_fields(state, "string", kString);
    copy_fields(state, "table", kTable);
    set_text_functions(state);
    set_table_functions(state);
    set_string_methods(state);
    lua_pushcfunction(state, trampoline<ordered_pairs>);
    lua_setfield(state, -2, "pairs");
    lua_pushcfunction(state, trampoline<ordered_next>);
    lua_setfield(state, -2, "next");
    lua_pushcfunction(state, safe_pcall);
    lua_setfield(state, -2, "pcall");
}

void make_nil_vacant(lua_State* state) {
    static constexpr std::array kMethods = {
        luaL_Reg{"__add", vacant_arithmetic<LUA_OPADD>},
        luaL_Reg{"__sub", vacant_arithmetic<LUA_OPSUB>},
        luaL_Reg{"__mul", vacant_arithmetic<LUA_OPMUL>},
        luaL_Reg{"__div", vacant_arithmetic<LUA_OPDIV>},
        luaL_Reg{"__pow", vacant_arithmetic<LUA_OPPOW>},
        luaL_Reg{"__unm", vacant_minus},
        luaL_Reg{"__lt", vacant_less},
        luaL_Reg{"__le", vacant_less_equal},
    };
    lua_pushnil(state);
    lua_createtable(state, 0, static_cast<int>(kMethods.size()));
    for (const luaL_Reg& method : kMethods) {
        lua_pushcfunction(state, method.func);
        lua_setfield(state, -2, method.name);
    }
    lua_setmetatable(state, -2);
    lua_pop(state, 1);
}

}  // namespace gsim::script
