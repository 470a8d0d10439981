#pragma once

#include <lua.hpp>

namespace gsim::script {

/// Pushes a new table with the part of Lua's own library that a script may use. It has no files, processes,
/// bytecode, debugging or metatables. It has no patterns, because a search can run indefinitely beyond any
/// limit. Its pcall does not catch the end of a run. `print` writes to standard error, because standard
/// output may be a report.
void push_safe_library(lua_State* state);

/// Makes nil, the value of a vacant variable, count as zero in arithmetic and comparison.
void make_nil_vacant(lua_State* state);

}  // namespace gsim::script
