#include "runtime/script/lua/data_tables.h"

#include <array>
#include <cmath>
#include <utility>

#include "runtime/script/lua/lua_state.h"

namespace gsim::script {

namespace {

using machine::AxisValues;
using machine::Tool;

struct ToolField {
    const char* name;
    double Tool::*value;
};

constexpr std::array kToolFields{ToolField{"length", &Tool::length_mm},
                                 ToolField{"diameter", &Tool::diameter_mm},
                                 ToolField{"length_wear", &Tool::length_wear_mm},
                                 ToolField{"diameter_wear", &Tool::diameter_wear_mm},
                                 ToolField{"front_angle", &Tool::front_angle_deg},
                                 ToolField{"back_angle", &Tool::back_angle_deg}};
constexpr std::size_t kRequiredFields = 2;
constexpr const char* kAxisLetters = "abcuvwxyz";

void set_axis_values(lua_State* state, const AxisValues& values) {
    for (const auto& [letter, value] : values) {
        const char key[] = {static_cast<char>(letter | 0x20), '\0'};
        set_number(state, key, value);
    }
}

void push_tool(lua_State* state, const Tool& tool) {
    lua_newtable(state);
    for (std::size_t i = 0; i < kToolFields.size(); ++i) {
        const double value = tool.*kToolFields[i].value;
        if (i < kRequiredFields || value != 0) set_number(state, kToolFields[i].name, value);
    }
    if (tool.orientation != 0) set_number(state, "orientation", tool.orientation);
    set_axis_values(state, tool.offsets);
}

AxisValues read_axis_values(lua_State* state) {
    AxisValues values;
    for (const char* letter = kAxisLetters; *letter != '\0'; ++letter) {
        const char key[] = {*letter, '\0'};
        lua_getfield(state, -1, key);
        if (!lua_isnil(state, -1)) values[static_cast<char>(*letter & ~0x20)] = luaL_checknumber(state, -1);
        lua_pop(state, 1);
    }
    return values;
}

/// Keeps the kind, because no program changes it.
void read_tool(lua_State* state, Tool& tool) {
    luaL_checktype(state, -1, LUA_TTABLE);
    for (const ToolField& field : kToolFields) tool.*field.value = number_field(state, -1, field.name);
    tool.orientation = static_cast<int>(std::lround(number_field(state, -1, "orientation")));
    tool.offsets = read_axis_values(state);
}

/// Sets core[name]: a table of points by their numbers, each with the values of axes and perhaps a name.
void set_points(lua_State* state, const char* name, const std::map<int, AxisValues>& points,
                const std::map<int, std::string>& names) {
    lua_newtable(state);
    for (const auto& [number, values] : points) {
        lua_newtable(state);
        set_axis_values(state, values);
        if (const auto known = names.find(number); known != names.end()) {
            lua_pushlstring(state, known->second.data(), known->second.size());
            lua_setfield(state, -2, "name");
        }
        lua_rawseti(state, -2, number);
    }
    lua_setfield(state, -2, name);
}

/// Calls read() for each entry of a table in the table on top, with the entry's value on top.
template <typename Read>
void for_each_entry(lua_State* state, const char* table, Read read) {
    lua_getfield(state, -1, table);
    luaL_checktype(state, -1, LUA_TTABLE);
    lua_pushnil(state);
    while (lua_next(state, -2) != 0) {
        read();
        lua_pop(state, 1);
    }
    lua_pop(state, 1);
}

int key_number(lua_State* state) {
    return static_cast<int>(luaL_checkinteger(state, -2));
}

}  // namespace

void set_data_tables(lua_State* state, const machine::MachineData& data) {
    lua_newtable(state);
    for (const auto& [code, values] : data.offsets) {
        lua_newtable(state);
        set_axis_values(state, values);
        lua_setfield(state, -2, code.c_str());
    }
    lua_setfield(state, -2, "offsets");
    set_points(state, "homes", data.homes, {});
    set_points(state, "fixed", data.fixed, data.fixed_names);
    set_points(state, "references", data.references, data.reference_names);
    lua_newtable(state);
    for (const auto& [number, value] : data.variables) {
        lua_pushnumber(state, value);
        lua_rawseti(state, -2, number);
    }
    lua_setfield(state, -2, "variables");
    lua_newtable(state);
    for (const auto& [number, tool] : data.tools) {
        push_tool(state, tool);
        lua_rawseti(state, -2, number);
    }
    lua_setfield(state, -2, "tools");
}

void read_data_tables(lua_State* state, machine::MachineData& data) {
    luaL_checktype(state, -1, LUA_TTABLE);
    data.offsets.clear();
    for_each_entry(state, "offsets", [&] {
        luaL_checktype(state, -1, LUA_TTABLE);
        luaL_checktype(state, -2, LUA_TSTRING);
        data.offsets[lua_tostring(state, -2)] = read_axis_values(state);
    });
    data.variables.clear();
    for_each_entry(state, "variables",
                   [&] { data.variables[key_number(state)] = luaL_checknumber(state, -1); });
    std::map<int, Tool> before = std::exchange(data.tools, {});
    for_each_entry(state, "tools", [&] {
        Tool tool = before[key_number(state)];
        read_tool(state, tool);
        data.tools[key_number(state)] = std::move(tool);
    });
}

}  // namespace gsim::script
