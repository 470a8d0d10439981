#pragma once

#include <lua.hpp>

namespace gsim::script {

// Lua visits a table in an order that depends on its hashes, which differ from process to process. These
// functions visit it by its keys: numbers, then texts by their bytes, false, true, then tables in the order
// of their creation. A table may have one key of other types (functions, userdata).

/// Implements pairs(t). Entries that are added meanwhile are not visited.
int ordered_pairs(lua_State* state);
/// Implements next(t, key): returns the entry with the smallest key, or with the next one above `key`. It
/// scans the full table.
int ordered_next(lua_State* state);

}  // namespace gsim::script
