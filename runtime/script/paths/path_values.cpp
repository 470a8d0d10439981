#include "runtime/script/paths/path_values.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "toolpath/json/touches.h"

namespace gsim::script::path_values {

using path::PathDraft;
using path::PathKey;
using path::TargetDraft;
using path::TargetKey;
using path::TouchDraft;
using path::TouchKey;

void raise(lua_State* state, const std::string& message) {
    luaL_where(state, 1);
    lua_pushlstring(state, message.data(), message.size());
    lua_concat(state, 2);
    lua_error(state);
    std::abort();  // lua_error does not return
}

void check(lua_State* state, const Result<void>& done) {
    if (!done) raise(state, done.error().message);
}

std::string_view text_at(lua_State* state, int index) {
    std::size_t size = 0;
    const char* text = lua_tolstring(state, index, &size);
    return {text, size};
}

namespace {

std::vector<double> numbers_at(lua_State* state, int table, std::string_view key) {
    std::vector<double> numbers;
    if (lua_istable(state, table)) {
        const lua_Unsigned count = std::min<lua_Unsigned>(lua_rawlen(state, table), 4);
        for (lua_Unsigned i = 1; i <= count; ++i) {
            if (lua_rawgeti(state, table, static_cast<lua_Integer>(i)) == LUA_TNUMBER) {
                numbers.push_back(lua_tonumber(state, -1));
            }
            lua_pop(state, 1);
        }
    }
    if (numbers.size() != 3) raise(state, fmt::format("'{}' must be a table of three numbers", key));
    return numbers;
}

void read_letters(lua_State* state, TargetDraft& draft, int table) {
    if (!lua_istable(state, table)) raise(state, "'rotary_deg' must be a table such as {B = 90}");
    draft.begin_rotary();
    std::map<std::string, double> values;  // in the order of the letters, which that of a table is not
    for (lua_pushnil(state); lua_next(state, table) != 0; lua_pop(state, 1)) {
        if (lua_type(state, -2) != LUA_TSTRING || lua_type(state, -1) != LUA_TNUMBER) {
            raise(state, "'rotary_deg' must be a table such as {B = 90}");
        }
        values.emplace(text_at(state, -2), lua_tonumber(state, -1));
    }
    for (const auto& [letter, value] : values) check(state, draft.set_rotary(letter, value));
}

void read_actions(lua_State* state, TargetDraft& draft, int table) {
    if (!lua_istable(state, table)) raise(state, "'actions' must be a table of strings");
    const auto count = static_cast<lua_Integer>(lua_rawlen(state, table));
    for (lua_Integer i = 1; i <= count; ++i) {
        if (lua_rawgeti(state, table, i) != LUA_TSTRING) raise(state, "'actions' must be a table of strings");
        draft.add_action(std::string(text_at(state, -1)));
        lua_pop(state, 1);
    }
}

// The value is on top of the stack.
void read_value(lua_State* state, TouchDraft& draft, TouchKey key) {
    const int value = lua_gettop(state);
    const std::string_view name = path::key_name(key);
    switch (TouchDraft::value_kind(key)) {
        case TouchDraft::ValueKind::text:
            if (lua_type(state, value) != LUA_TSTRING)
                raise(state, fmt::format("'{}' must be a string", name));
            return check(state, draft.set_text(key, text_at(state, value)));
        case TouchDraft::ValueKind::number:
            if (lua_type(state, value) != LUA_TNUMBER)
                raise(state, fmt::format("'{}' must be a number", name));
            return check(state, draft.set_number(key, lua_tonumber(state, value)));
        case TouchDraft::ValueKind::vector:
            return check(state, draft.set_vector(key, numbers_at(state, value, name)));
    }
}

path::Touch read_touch(lua_State* state, int table) {
    if (!lua_istable(state, table)) raise(state, "'probe_offset' must be a table of touches, each a table");
    for (lua_pushnil(state); lua_next(state, table) != 0; lua_pop(state, 1)) {
        const std::string_view name =
            lua_type(state, -2) == LUA_TSTRING ? text_at(state, -2) : std::string_view("[..]");
        if (std::find(path::kTouchKeys.begin(), path::kTouchKeys.end(), name) == path::kTouchKeys.end())
            raise(state, path::unknown_key(name, "a touch", path::kTouchKeys));
    }
    TouchDraft draft;
    for (std::size_t i = 0; i < path::kTouchKeys.size(); ++i) {
        lua_pushlstring(state, path::kTouchKeys[i].data(), path::kTouchKeys[i].size());
        if (lua_rawget(state, table) != LUA_TNIL) {
            draft.mark_present(static_cast<TouchKey>(i));
            read_value(state, draft, static_cast<TouchKey>(i));
        }
        lua_pop(state, 1);
    }
    auto touch = draft.finish();
    if (!touch) raise(state, touch.error().message);
    return *touch;
}

template <typename Draft>
void read_touches(lua_State* state, Draft& draft, int table) {
    if (!lua_istable(state, table)) raise(state, "'probe_offset' must be a table of touches, each a table");
    const auto count = static_cast<lua_Integer>(lua_rawlen(state, table));
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(state, table, i);
        draft.add_touch(read_touch(state, lua_gettop(state)));
        lua_pop(state, 1);
    }
    check(state, draft.end_touches());
}

// The value is on top of the stack.
void read_value(lua_State* state, PathDraft& draft, PathKey key) {
    const int value = lua_gettop(state);
    const std::string_view name = path::key_name(key);
    switch (PathDraft::value_kind(key)) {
        case PathDraft::ValueKind::text:
            if (lua_type(state, value) != LUA_TSTRING)
                raise(state, fmt::format("'{}' must be a string", name));
            return check(state, draft.set_text(key, text_at(state, value)));
        case PathDraft::ValueKind::number:
            if (lua_type(state, value) != LUA_TNUMBER)
                raise(state, fmt::format("'{}' must be a number", name));
            return check(state, draft.set_number(key, lua_tonumber(state, value)));
        case PathDraft::ValueKind::vector:
            return check(state, draft.set_vector(key, numbers_at(state, value, name)));
        case PathDraft::ValueKind::touches: return read_touches(state, draft, value);
        case PathDraft::ValueKind::other: return;
    }
}

}  // namespace

void read_value(lua_State* state, TargetDraft& draft, TargetKey key) {
    const int value = lua_gettop(state);
    const std::string_view name = path::key_name(key);
    switch (TargetDraft::value_kind(key)) {
        case TargetDraft::ValueKind::text:
            if (lua_type(state, value) != LUA_TSTRING)
                raise(state, fmt::format("'{}' must be a string", name));
            return check(state, draft.set_text(key, text_at(state, value)));
        case TargetDraft::ValueKind::number:
            if (lua_type(state, value) != LUA_TNUMBER)
                raise(state, fmt::format("'{}' must be a number", name));
            return check(state, draft.set_number(key, lua_tonumber(state, value)));
        case TargetDraft::ValueKind::text_or_number:
            if (lua_type(state, value) == LUA_TNUMBER)
                return check(state, draft.set_number(key, lua_tonumber(state, value)));
            if (lua_type(state, value) != LUA_TSTRING)
                raise(state, fmt::format("'{}' must be a name or a number", name));
            return check(state, draft.set_text(key, text_at(state, value)));
        case TargetDraft::ValueKind::vector:
            return check(state, draft.set_vector(key, numbers_at(state, value, name)));
        case TargetDraft::ValueKind::touches: return read_touches(state, draft, value);
        case TargetDraft::ValueKind::letters: return read_letters(state, draft, value);
        case TargetDraft::ValueKind::list: return read_actions(state, draft, value);
    }
}

PathDraft read_set_up(lua_State* state, int table, std::size_t keys) {
    PathDraft draft;
    for (std::size_t i = 0; i < keys; ++i) {
        lua_pushlstring(state, kSetUpKeys[i].data(), kSetUpKeys[i].size());
        if (lua_rawget(state, table) != LUA_TNIL)
            read_value(state, draft, static_cast<PathKey>(path::kRequiredPathKeys + i));
        lua_pop(state, 1);
    }
    return draft;
}

}  // namespace gsim::script::path_values
