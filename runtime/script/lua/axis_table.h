#pragma once

#include <lua.hpp>

#include "runtime/script/lua/interpreter.h"

namespace gsim::script {

/// Pushes a table with the value of every axis by its lower-case letter, in machine coordinates.
void push_axes(lua_State* state, const Interpreter& interpreter, const simulation::AxisVector& values);

/// Returns the axis values of the table at `index`; axes that are not named have the value in
/// `defaults`.
simulation::AxisVector check_axes(lua_State* state, const Interpreter& interpreter, int index,
                                  simulation::AxisVector defaults);
/// Returns the same, but axes that are not named stay at the program's position.
simulation::AxisVector check_axes(lua_State* state, const Interpreter& interpreter, int index);

}  // namespace gsim::script
