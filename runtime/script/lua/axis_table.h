#pragma once

#include <lua.hpp>

#include "runtime/script/lua/interpreter.h"

namespace gsim::script {

/// Pushes a table with the value of every axis by its lower-case letter, in machine coordinates.
void push_axes(lua_State* state, const Interpreter& interpreter, const simulation::AxisVector& values);

/// The axis values of the table at `index`; axes that are not named have the value in `rest`.
simulation::AxisVector check_axes(lua_State* state, const Interpreter& interpreter, int index,
                                  simulation::AxisVector rest);
/// The same, where axes that are not named stay where the program is.
simulation::AxisVector check_axes(lua_State* state, const Interpreter& interpreter, int index);

}  // namespace gsim::script
