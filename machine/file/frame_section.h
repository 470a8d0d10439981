#pragma once

#include <string>

#include "base/toml/toml_section.h"
#include "machine/model/frame.h"

namespace gsim::machine {

/// A frame as machine files and their kin have it: x_mm, y_mm, z_mm, roll_deg, pitch_deg and yaw_deg, each 0
/// where it is left out, as all are without a table. `title` names the table in errors.
Frame read_frame(base::FirstError& error, const toml::table* table, std::string title);

/// A frame as the value of a key: "{ x_mm = 1.0, ... }".
std::string inline_frame(const Frame& frame);

}  // namespace gsim::machine
