#include "runtime/script/lua/text_functions.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "base/text/number.h"
#include "base/text/printable.h"
#include "runtime/script/lua/lua_state.h"
#include "runtime/script/lua/object_names.h"

namespace gsim::script {

namespace {

int to_text(lua_State* state) {
    luaL_checkany(state, 1);
    push_text(state, 1);
    return 1;
}

/// Implements print(..) to standard error, up to the limit of a run.
int print_to_error(lua_State* state) {
    const int count = lua_gettop(state);
    std::string line;
    for (int i = 1; i <= count; ++i) {
        if (lua_type(state, i) == LUA_TNUMBER && lua_isinteger(state, i) == 0) {
            lua_pushnumber(state, text::unsigned_zero(lua_tonumber(state, i)));
            lua_replace(state, i);
        }
        const std::string_view text = push_text(state, i);
        if (i > 1) line += '\t';
        line += text::printable(text);
        lua_pop(state, 1);
    }
    line += '\n';
    std::fputs(LuaState::of(state).printed(std::move(line)).c_str(), stderr);
    return 0;
}

/// Calls the function in the first upvalue with all arguments.
int call_original(lua_State* state) {
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_insert(state, 1);
    lua_call(state, lua_gettop(state) - 1, LUA_MULTRET);
    return lua_gettop(state);
}

/// Implements tonumber(value [, base]): a text is read to its end.
int to_number(lua_State* state) {
    if (lua_type(state, 1) == LUA_TSTRING) LuaState::of(state).charge(state, lua_rawlen(state, 1));
    return call_original(state);
}

/// Implements string.find(s, text [, from]): a plain search, in a time proportional to the length of s.
int plain_find(lua_State* state) {
    // The C library's search is linear for a long text. For a short one its cost is at most the product of
    // both lengths.
    constexpr std::size_t kShort = 256;
    constexpr std::size_t kBytesAtOnce = 16;
    std::size_t size = 0;
    std::size_t required_size = 0;
    const char* text = luaL_checklstring(state, 1, &size);
    const char* requested = luaL_checklstring(state, 2, &required_size);
    const lua_Integer from = luaL_optinteger(state, 3, 1);
    const std::size_t begin = from < 1 ? 0 : static_cast<std::size_t>(from) - 1;
    if (begin > size) return 0;
    LuaState::of(state).charge(state, (size - begin) * (1 + std::min(required_size, kShort) / kBytesAtOnce));
    const void* const found = ::memmem(text + begin, size - begin, requested, required_size);
    if (found == nullptr) return 0;
    const auto first = static_cast<lua_Integer>(static_cast<const char*>(found) - text) + 1;
    lua_pushinteger(state, first);
    lua_pushinteger(state, first + static_cast<lua_Integer>(required_size) - 1);
    return 2;
}

/// Implements string.rep(s, count [, separator]); Lua's own one counts for years if the text to repeat is
/// empty.
int bounded_rep(lua_State* state) {
    std::size_t size = 0;
    std::size_t separator_size = 0;
    luaL_checklstring(state, 1, &size);
    luaL_checkinteger(state, 2);
    luaL_optlstring(state, 3, "", &separator_size);
    if (size + separator_size > 0) return call_original(state);
    lua_pushliteral(state, "");
    return 1;
}

/// Implements string.byte(s [, first [, last]]): returns as many values as bytes.
int counted_byte(lua_State* state) {
    const int count = call_original(state);
    LuaState::of(state).register_large_value(static_cast<std::uint64_t>(count) * LuaState::kBytesOfValue);
    LuaState::of(state).charge(state, static_cast<std::uint64_t>(count) * LuaState::kBytesOfValue);
    return count;
}

/// Returns the position of the conversion letter that belongs to a '%' at `at`.
std::size_t end_of_conversion(std::string_view form, std::size_t at) {
    return std::min(form.find_first_not_of("-+ #0123456789.", at), form.size());
}

/// Implements string.format(form, ..): %s writes a table without its address, and %p is not supported.
int repeatable_format(lua_State* state) {
    std::size_t size = 0;
    const char* const begin = luaL_checklstring(state, 1, &size);
    const std::string_view form(begin, size);
    const int count = lua_gettop(state);
    LuaState::of(state).charge(state, size);
    int argument = 1;
    for (std::size_t at = form.find('%'); at != std::string_view::npos; at = form.find('%', at + 1)) {
        at = end_of_conversion(form, at + 1);
        if (at == form.size()) break;
        if (form[at] == '%') continue;
        ++argument;
        if (form[at] == 'p')
            return luaL_argerror(state, 1, "%p writes an address, which differs between runs");
        if (form[at] != 's' || argument > count || lua_type(state, argument) == LUA_TSTRING) continue;
        push_text(state, argument);
        lua_replace(state, argument);
    }
    return call_original(state);
}

void wrap(lua_State* state, const char* name, lua_CFunction function) {
    lua_getfield(state, -1, name);
    lua_pushcclosure(state, function, 1);
    lua_setfield(state, -2, name);
}

void set(lua_State* state, const char* name, lua_CFunction function) {
    lua_pushcfunction(state, function);
    lua_setfield(state, -2, name);
}

}  // namespace

void set_text_functions(lua_State* state) {
    set(state, "tostring", trampoline<to_text>);
    set(state, "print", trampoline<print_to_error>);
    wrap(state, "tonumber", trampoline<to_number>);
    lua_getfield(state, -1, "string");
    set(state, "find", trampoline<plain_find>);
    wrap(state, "rep", trampoline<bounded_rep>);
    wrap(state, "byte", trampoline<counted_byte>);
    wrap(state, "format", trampoline<repeatable_format>);
    lua_pop(state, 1);
}

}  // namespace gsim::script
