#pragma once

#include <string>

#include "base/toml/toml_section.h"
#include "machine/model/frame.h"

namespace gsim::machine {

/// Reads a frame of a machine file or a similar file: x_mm, y_mm, z_mm, roll_deg, pitch_deg and yaw_deg. Each
/// is 0 if omitted, as all are without a table. `title` names the table in errors.
Frame read_frame(base::FirstError& error, const toml::table* table, std::string title);

/// Returns a frame as the value of a key: "{ x_mm = 1.0, ... }".
std::string inline_frame(const Frame& frame);

}  // namespace gsim::machine
