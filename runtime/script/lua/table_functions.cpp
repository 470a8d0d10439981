#include "runtime/script/lua/table_functions.h"

#include <algorithm>
#include <limits>

#include "runtime/script/lua/lua_state.h"

namespace gsim::script {

namespace {

/// Cost of one table element, in bytes of a string.
constexpr std::uint64_t kBytesOfElement = 256;
/// Longer ranges end in an error by themselves, or by the memory.
constexpr lua_Number kMaxElements = 1e9;

// Stack of stable_sort().
constexpr int kList = 1;
constexpr int kComparison = 2;
constexpr int kFirst = 3;
constexpr int kSecond = 4;

/// Returns the number of elements that a function processes with these arguments; 0 also if it will reject
/// them.
using CountElements = lua_Number (*)(lua_State* state);

lua_Number length(lua_State* state) {
    return static_cast<lua_Number>(lua_rawlen(state, 1));
}

/// Counts the elements of table.unpack(t, first, last) and table.concat(t, separator, first, last): the range
/// begins at argument `first`.
template <int First>
lua_Number elements_of_range(lua_State* state) {
    const lua_Number first = lua_isnoneornil(state, First) ? 1 : lua_tonumber(state, First);
    const lua_Number last =
        lua_isnoneornil(state, First + 1) ? length(state) : lua_tonumber(state, First + 1);
    return last - first + 1;
}

/// Counts the elements that table.insert(t, position, value) and table.remove(t, position) move.
template <int Arguments>
lua_Number elements_after(lua_State* state) {
    return lua_gettop(state) < Arguments ? 0 : length(state) - lua_tonumber(state, 2) + 1;
}

/// Calls the function in the upvalue once its work has been counted.
template <CountElements Count, bool ManyResults>
int charge_and_call(lua_State* state) {
    if (lua_istable(state, 1)) {
        LuaState& lua = LuaState::of(state);
        const auto count = static_cast<std::uint64_t>(std::min(kMaxElements, std::max(0.0, Count(state))));
        lua.charge(state, count * kBytesOfElement);
        if (ManyResults) lua.register_large_value(count * LuaState::kBytesOfValue);
    }
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_insert(state, 1);
    lua_call(state, lua_gettop(state) - 1, LUA_MULTRET);
    return lua_gettop(state);
}

/// Returns true if the value on top of the stack comes before the one under it.
bool top_is_before(lua_State* state) {
    if (lua_isnil(state, kComparison)) return lua_compare(state, -1, -2, LUA_OPLT) != 0;
    lua_pushvalue(state, kComparison);
    lua_pushvalue(state, -2);
    lua_pushvalue(state, -4);
    lua_call(state, 2, 1);
    const bool before = lua_toboolean(state, -1) != 0;
    lua_pop(state, 1);
    return before;
}

/// Merges [begin, middle) and [middle, end) of the list at `from` into the list at `to`; the first of equal
/// elements stays the first.
void merge(lua_State* state, int from, int to, lua_Integer begin, lua_Integer middle, lua_Integer end) {
    lua_Integer one = begin;
    lua_Integer other = middle;
    for (lua_Integer at = begin; at < end; ++at) {
        bool take_second = one == middle;
        if (!take_second && other < end) {
            lua_rawgeti(state, from, one);
            lua_rawgeti(state, from, other);
            take_second = top_is_before(state);
            lua_pop(state, 2);
        }
        lua_rawgeti(state, from, take_second ? other++ : one++);
        lua_rawseti(state, to, at);
    }
}

/// Implements table.sort(t [, is_before]): stable, by merging. It ends regardless of the results of the
/// comparison.
int stable_sort(lua_State* state) {
    luaL_checktype(state, kList, LUA_TTABLE);
    if (!lua_isnoneornil(state, kComparison)) luaL_checktype(state, kComparison, LUA_TFUNCTION);
    const lua_Integer count = luaL_len(state, kList);
    luaL_argcheck(state, count < std::numeric_limits<int>::max(), kList, "the list is too long");
    if (count < 2) return 0;
    LuaState& lua = LuaState::of(state);
    const std::uint64_t work = static_cast<std::uint64_t>(count) * kBytesOfElement;
    lua.charge(state, work);
    lua_settop(state, kComparison);
    lua_createtable(state, static_cast<int>(count), 0);
    lua_createtable(state, static_cast<int>(count), 0);
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_geti(state, kList, i);
        lua_rawseti(state, kFirst, i);
    }
    int from = kFirst;
    int to = kSecond;
    for (lua_Integer width = 1; width < count; width *= 2) {
        lua.charge(state, work);
        for (lua_Integer begin = 1; begin <= count; begin += 2 * width) {
            merge(state, from, to, begin, std::min(begin + width, count + 1),
                  std::min(begin + 2 * width, count + 1));
        }
        std::swap(from, to);
    }
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(state, from, i);
        lua_seti(state, kList, i);
    }
    return 0;
}

template <CountElements Count, bool ManyResults = false>
void wrap_counted(lua_State* state, const char* name) {
    lua_getfield(state, -1, name);
    lua_pushcclosure(state, trampoline<charge_and_call<Count, ManyResults>>, 1);
    lua_setfield(state, -2, name);
}

}  // namespace

void set_table_functions(lua_State* state) {
    lua_getfield(state, -1, "table");
    wrap_counted<elements_of_range<3>>(state, "concat");
    wrap_counted<elements_of_range<2>, true>(state, "unpack");
    wrap_counted<elements_after<3>>(state, "insert");
    wrap_counted<elements_after<2>>(state, "remove");
    lua_pushcfunction(state, trampoline<stable_sort>);
    lua_setfield(state, -2, "sort");
    lua_pop(state, 1);
}

}  // namespace gsim::script
