#pragma once

#include "calibrate/command.h"

namespace gsim::calibrate {

/// gsim-calibrate times: what a machine file leaves open, from recorded runs.
void add_times(apps::CommandLine& line, Chosen& chosen);

}  // namespace gsim::calibrate
