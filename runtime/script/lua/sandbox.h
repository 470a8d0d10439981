#pragma once

#include <lua.hpp>

namespace gsim::script {

/// Pushes a new table with all that a script may use of Lua's own library: no files, processes, bytecode or
/// debugging, no patterns (a search can run for ever where no limit reaches it), no metatables, and a pcall
/// that does not catch the end of a run. `print` writes to standard error, since standard output may be a
/// report.
void push_safe_library(lua_State* state);

/// Makes nil, the value of a vacant variable, count as zero in arithmetic and comparison.
void make_nil_vacant(lua_State* state);

}  // namespace gsim::script
