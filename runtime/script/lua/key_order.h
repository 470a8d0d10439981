#pragma once

#include <lua.hpp>

namespace gsim::script {

// Lua goes through a table in an order that its hashes give, which differ from process to process. These go
// through it by its keys: numbers, then texts by their bytes, false, true, then tables in the order in which
// they were made. Of other keys (functions, userdata) a table may have one.

/// pairs(t). Entries that are added meanwhile are not visited.
int ordered_pairs(lua_State* state);
/// next(t, key): the entry with the least key, or with the least one behind `key`. It looks at the whole
/// table.
int ordered_next(lua_State* state);

}  // namespace gsim::script
