#pragma once

#include <lua.hpp>

namespace gsim::script {

/// Puts, in the place of functions of the table on top of the stack, a safe part of Lua's library, ones that
/// count their work and give the same texts in each run: tostring, tonumber, print and those of `string`.
void set_text_functions(lua_State* state);

}  // namespace gsim::script
