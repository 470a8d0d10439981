#pragma once

#include <string>
#include <vector>

namespace gsim::calibrate {

/// gsim-calibrate servo: the servo loops of a machine's axes from a recording of set points and places. The
/// exit status.
int run_servo(const std::vector<std::string>& words);

}  // namespace gsim::calibrate
