#include "runtime/script/lua/key_order.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <span>
#include <string_view>

#include "runtime/script/lua/lua_state.h"

namespace gsim::script {

namespace {

/// Work to check one key, as LuaState::charge() counts it.
constexpr std::uint64_t kBytesOfKey = 256;

enum class Rank : std::uint8_t { number, text, no, yes, table, other };

struct Key {
    Rank rank = Rank::other;
    bool integer = false;
    lua_Integer integer_value = 0;  ///< Value of an integer.
    lua_Number number = 0;          ///< Value of another number.
    std::string_view text = {};     ///< As long as the table holds it.
    std::uint64_t serial = 0;       ///< Serial of a table.
    lua_Integer found = 0;          ///< The how many-th of its table it is, by Lua's order.
};

/// Compares exactly even if one is an integer and the other is not: a long double has all digits of both.
std::partial_ordering compare_numbers(const Key& a, const Key& b) {
    if (a.integer && b.integer) return a.integer_value <=> b.integer_value;
    const auto value = [](const Key& key) {
        return key.integer ? static_cast<long double>(key.integer_value)
                           : static_cast<long double>(key.number);
    };
    return value(a) <=> value(b);
}

bool is_before(const Key& a, const Key& b) {
    if (a.rank != b.rank) return a.rank < b.rank;
    switch (a.rank) {
        case Rank::number: return compare_numbers(a, b) < 0;
        case Rank::text: return a.text < b.text;
        case Rank::table: return a.serial < b.serial;
        default: return false;
    }
}

Key key_at(lua_State* state, int index) {
    Key key;
    switch (lua_type(state, index)) {
        case LUA_TNUMBER:
            key.rank = Rank::number;
            key.integer = lua_isinteger(state, index) != 0;
            if (key.integer) {
                key.integer_value = lua_tointeger(state, index);
            } else {
                key.number = lua_tonumber(state, index);
            }
            break;
        case LUA_TSTRING: {
            std::size_t size = 0;
            const char* const text = lua_tolstring(state, index, &size);
            key.rank = Rank::text;
            key.text = {text, size};
            break;
        }
        case LUA_TBOOLEAN: key.rank = lua_toboolean(state, index) != 0 ? Rank::yes : Rank::no; break;
        case LUA_TTABLE:
            key.serial = LuaState::of(state).table_serials().of(lua_topointer(state, index));
            key.rank = key.serial > 0 ? Rank::table : Rank::other;
            break;
        default: break;
    }
    return key;
}

/// Raises an error for a second key that has no known position among the others.
void count_unordered(lua_State* state, const Key& key, int& others) {
    if (key.rank != Rank::other || ++others < 2) return;
    luaL_error(state,
               "pairs and next cannot iterate over a table with several functions or userdata as keys: their "
               "order would differ between runs; store them in a list");
}

struct KeySummary {
    lua_Integer count = 0;
    bool sequence = true;  ///< The keys are 1, 2, .. count, and Lua has them in that order.
};

KeySummary summarize_keys(lua_State* state) {
    KeySummary found;
    for (lua_pushnil(state); lua_next(state, 1) != 0; lua_pop(state, 1)) {
        ++found.count;
        found.sequence =
            found.sequence && lua_isinteger(state, -2) != 0 && lua_tointeger(state, -2) == found.count;
    }
    return found;
}

/// Continues the list 1, 2, ..; upvalues: its length, and the current position.
int next_in_sequence(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    const lua_Integer count = lua_tointeger(state, lua_upvalueindex(1));
    lua_Integer at = lua_tointeger(state, lua_upvalueindex(2));
    while (at < count) {
        lua_pushinteger(state, ++at);
        if (lua_rawgeti(state, 1, at) == LUA_TNIL) {  // cleared meanwhile
            lua_pop(state, 2);
            continue;
        }
        lua_pushinteger(state, at);
        lua_replace(state, lua_upvalueindex(2));
        return 2;
    }
    lua_pushinteger(state, count);
    lua_replace(state, lua_upvalueindex(2));
    return 0;
}

/// Continues through keys in their order; upvalues: their list, and the current position.
int next_in_keys(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    lua_Integer at = lua_tointeger(state, lua_upvalueindex(2));
    while (lua_rawgeti(state, lua_upvalueindex(1), ++at) != LUA_TNIL) {
        lua_pushvalue(state, -1);
        if (lua_rawget(state, 1) == LUA_TNIL) {
            lua_pop(state, 2);
            continue;
        }
        lua_pushinteger(state, at);
        lua_replace(state, lua_upvalueindex(2));
        return 2;
    }
    return 0;
}

/// Pushes the list of a table's keys in their order.
void push_keys(lua_State* state, lua_Integer count) {
    const auto size = static_cast<std::size_t>(count);
    // Lua owns the memory, so it counts and is released if an error passes.
    auto* const memory = static_cast<Key*>(lua_newuserdatauv(state, size * sizeof(Key), 0));
    const std::span<Key> keys(memory, size);
    lua_createtable(state, static_cast<int>(count), 0);
    const int list = lua_gettop(state);
    lua_Integer found = 0;
    int others = 0;
    for (lua_pushnil(state); lua_next(state, 1) != 0;) {
        lua_pop(state, 1);
        Key key = key_at(state, -1);
        count_unordered(state, key, others);
        key.found = ++found;
        keys[static_cast<std::size_t>(found) - 1] = key;
        lua_pushvalue(state, -1);
        lua_rawseti(state, list, found);
    }
    std::sort(keys.begin(), keys.end(), is_before);
    lua_createtable(state, static_cast<int>(count), 0);
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(state, list, keys[static_cast<std::size_t>(i) - 1].found);
        lua_rawseti(state, -2, i);
    }
}

}  // namespace

int ordered_pairs(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    lua_settop(state, 1);
    const KeySummary found = summarize_keys(state);
    LuaState::of(state).charge(state, static_cast<std::uint64_t>(found.count) * kBytesOfKey);
    if (found.sequence) {
        lua_pushinteger(state, found.count);
    } else {
        push_keys(state, found.count);
    }
    lua_pushinteger(state, 0);
    lua_pushcclosure(state, found.sequence ? next_in_sequence : next_in_keys, 2);
    lua_pushvalue(state, 1);
    lua_pushnil(state);
    return 3;
}

int ordered_next(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    lua_settop(state, 2);
    const bool first = lua_isnil(state, 2);
    int others = 0;
    const Key after = key_at(state, 2);
    lua_pushnil(state);  // 3: the smallest key so far, and
    lua_pushnil(state);  // 4: its value
    Key min_key;
    std::uint64_t count = 0;
    for (lua_pushnil(state); lua_next(state, 1) != 0; lua_pop(state, 1)) {
        ++count;
        const Key key = key_at(state, -2);
        count_unordered(state, key, others);
        if (!first && !is_before(after, key)) continue;
        if (!lua_isnil(state, 3) && !is_before(key, min_key)) continue;
        min_key = key;
        lua_copy(state, -2, 3);
        lua_copy(state, -1, 4);
    }
    LuaState::of(state).charge(state, count * kBytesOfKey);
    lua_settop(state, 4);
    if (lua_isnil(state, 3)) lua_settop(state, 3);
    return lua_gettop(state) - 2;
}

}  // namespace gsim::script
