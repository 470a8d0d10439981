#pragma once

#include <span>

#include <lua.hpp>

namespace gsim::script {

/// The number, from 0, of the argument among `names`, which end with nullptr; `fallback` (or nullptr) stands
/// for an argument that is left out. What is none of them raises an error that tells all.
int check_choice(lua_State* state, int argument, const char* fallback, std::span<const char* const> names);

}  // namespace gsim::script
