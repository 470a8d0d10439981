#include <array>
#include <optional>

#include "runtime/script/bindings/bindings.h"
#include "runtime/script/lua/lua_state.h"

namespace gsim::script {

namespace {

double number_at(lua_State* state, lua_Integer argument_index) {
    lua_rawgeti(state, -1, argument_index);
    const double value = luaL_checknumber(state, -1);
    lua_pop(state, 1);
    return value;
}

/// Returns the walls of one axis in the table at `index`: a pair of numbers, the lower one first.
std::optional<machine::ZoneLimits> walls_at(lua_State* state, int index, const char* letter) {
    std::optional<machine::ZoneLimits> walls;
    if (lua_getfield(state, index, letter) == LUA_TTABLE) walls = {number_at(state, 1), number_at(state, 2)};
    lua_pop(state, 1);
    return walls;
}

/// core.set_zone({ x = { low, high }, ... }): the zone of the program, mm of machine coordinates; nil: none.
int set_zone(lua_State* state) {
    std::optional<simulation::ZoneWalls> walls;
    if (!lua_isnoneornil(state, 1)) {
        luaL_checktype(state, 1, LUA_TTABLE);
        walls = {walls_at(state, 1, "x"), walls_at(state, 1, "y"), walls_at(state, 1, "z")};
    }
    bound_interpreter(state).simulator().program().zones().set_programmed(walls);
    return 0;
}

/// core.switch_zones(number, on): returns false if no zone of the machine data has that number.
int switch_zones(lua_State* state) {
    const auto number = static_cast<int>(luaL_checkinteger(state, 1));
    const bool known = bound_interpreter(state).simulator().program().zones().switch_zones(
        number, lua_toboolean(state, 2) != 0);
    lua_pushboolean(state, static_cast<int>(known));
    return 1;
}

/// core.set_tool_offset(x, y, z): distance of the machine's position from the tool's end, mm.
int set_tool_offset(lua_State* state) {
    bound_interpreter(state).simulator().program().tool().set(
        {luaL_optnumber(state, 1, 0), luaL_optnumber(state, 2, 0), luaL_optnumber(state, 3, 0)});
    return 0;
}

}  // namespace

void add_zones(lua_State* state, Interpreter& interpreter) {
    set_function<set_zone>(state, "set_zone", &interpreter);
    set_function<switch_zones>(state, "switch_zones", &interpreter);
    set_function<set_tool_offset>(state, "set_tool_offset", &interpreter);
}

}  // namespace gsim::script
