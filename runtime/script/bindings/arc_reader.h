#pragma once

#include <Eigen/Core>

#include <lua.hpp>

#include "runtime/script/lua/interpreter.h"

namespace gsim::script {

/// A plane by its name ("xy", "zx" or "yz"); an error of Lua where the argument is none.
Plane check_plane(lua_State* state, int argument);
/// Pushes that name.
void push_plane(lua_State* state, Plane plane);

/// The plane of an arc on its way through Lua: two unit vectors of X, Y and Z at right angles, along which
/// its points are counted; counter-clockwise is from the first to the second.
struct ArcBasis {
    Eigen::Vector3d first, second;
};
/// Of a main plane: z and x of zx, and so on; of an oblique one any two.
ArcBasis arc_basis(const Eigen::Vector3d& normal);
/// What push_arc_plane() pushes, or a name; an error of Lua where the argument is neither.
ArcBasis check_arc_plane(lua_State* state, int argument);
/// Pushes the name of a main plane; of an oblique one a table { first = {x=, y=, z=}, second = {...} }.
void push_arc_plane(lua_State* state, const Eigen::Vector3d& normal);

/// The arc of the words in the table at `index`, from where the program is, in the plane, the frame and the
/// units in force; its feed and place are left as they are. Ends the run with an alarm where the words make
/// no arc.
simulation::ArcMove read_arc(lua_State* state, Interpreter& interpreter, bool ccw, int index);

}  // namespace gsim::script
