#pragma once

#include <span>

#include <lua.hpp>

namespace gsim::script {

/// Returns the number, from 0, of the argument among `names`, which end with nullptr; `fallback` (or nullptr)
/// is used for an omitted argument. Any other argument raises an error that lists all names.
int check_option(lua_State* state, int argument, const char* fallback, std::span<const char* const> names);

}  // namespace gsim::script
