#pragma once

#include <lua.hpp>

#include "runtime/script/lua/interpreter.h"
#include "runtime/script/lua/lua_state.h"

namespace gsim::script {

/// The interpreter of a function that was bound to it.
inline Interpreter& interpreter_of(lua_State* state) {
    return bound<Interpreter>(state);
}

// Each function adds its functions to the table on top of the stack; `interpreter` outlives the state.

/// What the library in Lua is built on: `core`, see lua_lib/README.md.
void add_core(lua_State* state, Interpreter& interpreter);
/// Functions of angles in degrees: core.sin_deg and so on.
void add_angles(lua_State* state, Interpreter& interpreter);
/// The words of plain moves, in C++ because programs are made of them: core.line_word, core.line.
void add_motion_words(lua_State* state, Interpreter& interpreter);
/// The words of plain arcs, likewise: core.arc_word, core.read_arc.
void add_arc_words(lua_State* state, Interpreter& interpreter);
/// Moves to machine coordinates, dwells and events, with the feed and the place that go with them.
void add_moves(lua_State* state, Interpreter& interpreter);
/// Program and machine coordinates: offsets, matrix, where the machine stands, where a move would end.
void add_frames(lua_State* state, Interpreter& interpreter);
/// Poses: their axis values (core.pose_axes), moves of the tool to them (core.pose_move).
void add_poses(lua_State* state, Interpreter& interpreter);
/// Groups of axes: core.group_names, core.group_motion, core.move_group and their kin.
void add_groups(lua_State* state, Interpreter& interpreter);
/// Zones, and where the tool's end is: core.set_zone, core.switch_zones, core.set_tool_offset.
void add_zones(lua_State* state, Interpreter& interpreter);
/// The services of the controller as scripts call them.
void add_rrs(lua_State* state, Interpreter& interpreter);

}  // namespace gsim::script
