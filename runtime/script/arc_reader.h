#pragma once

#include <lua.hpp>

#include "runtime/script/controller.h"

namespace gsim::script {

/// The arc of the words in the table at `index`, from where the program is, in the plane, the frame and the
/// units in force; its feed and place are left as they are. Ends the run with an alarm where the words make
/// no arc.
simulation::ArcMove read_arc(lua_State* state, Controller& controller, bool ccw, int index);

}  // namespace gsim::script
