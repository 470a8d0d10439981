#pragma once

#include <lua.hpp>

namespace gsim::script {

/// Puts, in the place of functions of field "table" of the table on top of the stack, ones that count their
/// work; and a sort that is stable, so that its result hangs on the list and the comparison alone.
void set_table_functions(lua_State* state);

}  // namespace gsim::script
