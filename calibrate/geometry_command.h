#pragma once

#include <string>
#include <vector>

namespace gsim::calibrate {

/// gsim-calibrate geometry: a machine's geometry from measured tips, poses to measure, and simulated
/// measurements. The exit status.
int run_geometry(const std::vector<std::string>& words);

}  // namespace gsim::calibrate
