#include "runtime/script/lua/axis_table.h"

namespace gsim::script {

using simulation::AxisVector;

namespace {

/// Key of an axis: its letter in lower case, as a text for the C interface of Lua.
struct AxisKey {
    explicit AxisKey(char letter) : text{static_cast<char>(letter | 0x20), '\0'} {}
    char text[2];
};

}  // namespace

void push_axes(lua_State* state, const Interpreter& interpreter, const AxisVector& values) {
    const auto& axes = interpreter.simulator().machine().axes;
    lua_createtable(state, 0, static_cast<int>(axes.size()));
    for (std::size_t i = 0; i < axes.size(); ++i) {
        lua_pushnumber(state, values[static_cast<Eigen::Index>(i)]);
        lua_setfield(state, -2, AxisKey(axes[i].letter).text);
    }
}

AxisVector check_axes(lua_State* state, const Interpreter& interpreter, int index, AxisVector defaults) {
    luaL_checktype(state, index, LUA_TTABLE);
    const auto& axes = interpreter.simulator().machine().axes;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        lua_getfield(state, index, AxisKey(axes[i].letter).text);
        if (!lua_isnil(state, -1)) defaults[static_cast<Eigen::Index>(i)] = luaL_checknumber(state, -1);
        lua_pop(state, 1);
    }
    return defaults;
}

AxisVector check_axes(lua_State* state, const Interpreter& interpreter, int index) {
    return check_axes(state, interpreter, index, interpreter.programmed());
}

}  // namespace gsim::script
