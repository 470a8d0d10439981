#pragma once

#include <lua.hpp>

#include "controller/services/types.h"

namespace gsim::script {

// A Cartesian position in Lua is a table of four rows of four numbers, a joint position is a list of numbers.

rrs::CartPos check_pose(lua_State* state, int index);
void push_pose(lua_State* state, const rrs::CartPos& pose);
rrs::JointPos check_joints(lua_State* state, int index, std::size_t count);
void push_joints(lua_State* state, const rrs::JointPos& joints);

}  // namespace gsim::script
