#pragma once

#include <lua.hpp>

#include "machine/data/machine_data.h"

namespace gsim::script {

/// Sets core.offsets["54"].x in mm or deg, core.homes[2].x, core.fixed[1].x and core.references[1].x, each of
/// these two with its name if it has one, core.variables[500], and core.tools[1] with length, diameter,
/// length_wear and diameter_wear in mm, offsets by axis letters, front_angle and back_angle in deg, and
/// orientation; values of 0 among these last are omitted. The table of core is on top of the stack.
void set_data_tables(lua_State* state, const machine::MachineData& data);

/// Reads offsets, tools and variables from the table on top of the stack, which has them as above; entries
/// that it does not have are removed from the data. Raises an error if it holds something else.
void read_data_tables(lua_State* state, machine::MachineData& data);

}  // namespace gsim::script
