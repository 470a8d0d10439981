#pragma once

#include <lua.hpp>

namespace gsim::script {

/// Replaces functions of the table on top of the stack, a safe part of Lua's library. The new ones count
/// their work and return the same texts in each run: tostring, tonumber, print and those of `string`.
void set_text_functions(lua_State* state);

}  // namespace gsim::script
