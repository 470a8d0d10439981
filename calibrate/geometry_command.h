#pragma once

#include "calibrate/command.h"

namespace gsim::calibrate {

/// gsim-calibrate geometry: a machine's geometry from measured tips, poses to measure, and simulated
/// measurements.
void add_geometry(apps::CommandLine& line, Chosen& chosen);

}  // namespace gsim::calibrate
