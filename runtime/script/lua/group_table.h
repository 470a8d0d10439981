#pragma once

#include <vector>

#include <lua.hpp>

#include "runtime/script/lua/interpreter.h"

namespace gsim::script {

/// Returns the positions to which a pose leads groups of axes: {table = {c = 90}} in the table at `index`, by
/// the names of the machine's groups and letters of their axes, mm or deg. An impossible position is an
/// alarm.
std::vector<simulation::GroupTarget> check_group_targets(lua_State* state, Interpreter& interpreter,
                                                         int index);

}  // namespace gsim::script
