#pragma once

#include <lua.hpp>

namespace gsim::script {

/// Replaces functions of field "table" of the table on top of the stack by ones that count their work. The
/// sort is stable, so its result depends on the list and the comparison alone.
void set_table_functions(lua_State* state);

}  // namespace gsim::script
