#pragma once

#include <Eigen/Core>

#include <lua.hpp>

#include "runtime/script/lua/interpreter.h"

namespace gsim::script {

/// Returns a plane by its name ("xy", "zx" or "yz"); raises an error of Lua if the argument is none.
Plane check_plane(lua_State* state, int argument);
/// Pushes that name.
void push_plane(lua_State* state, Plane plane);

/// Plane of an arc as it is passed through Lua: two unit vectors of X, Y and Z at right angles, along which
/// its points are counted; counter-clockwise is from the first to the second.
struct ArcBasis {
    Eigen::Vector3d first, second;
};
/// Returns the basis of a main plane: z and x for zx, and so on; for an oblique one any two.
ArcBasis arc_basis(const Eigen::Vector3d& normal);
/// Reads what push_arc_plane() pushes, or a name; raises an error of Lua if the argument is neither.
ArcBasis check_arc_plane(lua_State* state, int argument);
/// Pushes the name of a main plane; for an oblique one a table { first = {x=, y=, z=}, second = {...} }.
void push_arc_plane(lua_State* state, const Eigen::Vector3d& normal);

/// Reads the arc of the words in the table at `index`, from the program's position, in the active plane,
/// frame and units; its feed and place are left as they are. Ends the run with an alarm if the words make no
/// arc.
simulation::ArcMove read_arc(lua_State* state, Interpreter& interpreter, bool ccw, int index);

}  // namespace gsim::script
