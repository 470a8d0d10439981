#pragma once

#include <string_view>

#include <lua.hpp>

namespace gsim::script {

/// Pushes the value at `index` as text, as Lua's tostring does; but what Lua writes with an address, which
/// differs from run to run, has a number, in the order in which they are first asked for: "table: 1".
std::string_view push_text(lua_State* state, int index);

}  // namespace gsim::script
