#pragma once

#include <string_view>

#include <lua.hpp>

namespace gsim::script {

/// Pushes the value at `index` as text, like Lua's tostring. Lua writes some values with an address, which
/// differs from run to run. Such values get a number instead, in the order of their first use: "table: 1".
std::string_view push_text(lua_State* state, int index);

}  // namespace gsim::script
