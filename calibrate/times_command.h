#pragma once

#include <string>
#include <vector>

namespace gsim::calibrate {

/// gsim-calibrate times: what a machine file leaves open, from recorded runs. The exit status.
int run_times(const std::vector<std::string>& words);

}  // namespace gsim::calibrate
