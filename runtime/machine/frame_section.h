#pragma once

#include <string>

#include "runtime/machine/frame.h"
#include "runtime/machine/toml_section.h"

namespace gsim::machine {

/// A frame as machine files and their kin have it: x_mm, y_mm, z_mm, roll_deg, pitch_deg and yaw_deg, each 0
/// where it is left out, as all are without a table. `title` names the table in errors.
Frame read_frame(FirstError& error, const toml::table* table, std::string title);

}  // namespace gsim::machine
