#pragma once

#include "calibrate/command.h"

namespace gsim::calibrate {

/// gsim-calibrate servo: the servo loops of a machine's axes from a recording of set points and places.
void add_servo(apps::CommandLine& line, Chosen& chosen);

}  // namespace gsim::calibrate
