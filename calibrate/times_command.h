#pragma once

#include "calibrate/command.h"

namespace gsim::calibrate {

/// Adds gsim-calibrate times: open parameters of a machine file, from recorded runs.
void add_times_command(apps::CommandLine& line, SelectedCommand& selected);

}  // namespace gsim::calibrate
