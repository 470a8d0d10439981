#pragma once

#include "calibrate/command.h"

namespace gsim::calibrate {

/// Adds gsim-calibrate servo: the servo loops of a machine's axes from a recording of set points and
/// positions.
void add_servo_command(apps::CommandLine& line, SelectedCommand& selected);

}  // namespace gsim::calibrate
