#pragma once

#include "calibrate/command.h"

namespace gsim::calibrate {

/// Adds gsim-calibrate geometry: a machine's geometry from measured TCPs, poses to measure, and simulated
/// measurements.
void add_geometry_command(apps::CommandLine& line, SelectedCommand& selected);

}  // namespace gsim::calibrate
