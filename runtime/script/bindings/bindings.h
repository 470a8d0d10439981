#pragma once

#include <lua.hpp>

#include "runtime/script/lua/interpreter.h"
#include "runtime/script/lua/lua_state.h"

namespace gsim::script {

/// Returns the interpreter of a function that was bound to it.
inline Interpreter& bound_interpreter(lua_State* state) {
    return bound<Interpreter>(state);
}

// Each function adds its functions to the table on top of the stack; `interpreter` outlives the state.

/// Adds the base of the library in Lua: `core`, see lua_lib/README.md.
void add_core(lua_State* state, Interpreter& interpreter);
/// Adds functions of angles in degrees: core.sin_deg and so on.
void add_angles(lua_State* state, Interpreter& interpreter);
/// Adds the words of plain moves, in C++ because programs consist of them: core.line_word, core.line.
void add_motion_words(lua_State* state, Interpreter& interpreter);
/// Adds the words of plain arcs, likewise: core.arc_word, core.read_arc.
void add_arc_words(lua_State* state, Interpreter& interpreter);
/// Adds moves to machine coordinates, dwells and events, with their feed and source location.
void add_moves(lua_State* state, Interpreter& interpreter);
/// Adds program and machine coordinates: offsets, matrix, the position of the machine, the end of a move.
void add_frames(lua_State* state, Interpreter& interpreter);
/// Adds poses: their axis values (core.pose_axes), moves of the tool to them (core.pose_move).
void add_poses(lua_State* state, Interpreter& interpreter);
/// Adds groups of axes: core.group_names, core.group_motion, core.move_group and similar.
void add_groups(lua_State* state, Interpreter& interpreter);
/// Adds zones, and the position of the tool's end: core.set_zone, core.switch_zones, core.set_tool_offset.
void add_zones(lua_State* state, Interpreter& interpreter);
/// Adds the services of the controller as scripts call them.
void add_rrs(lua_State* state, Interpreter& interpreter);

}  // namespace gsim::script
