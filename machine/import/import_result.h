#pragma once

#include <string>
#include <vector>

#include "machine/data/machine_data.h"
#include "machine/model/machine.h"

namespace gsim::import {

/// Result of importing the settings of a controller.
struct ImportResult {
    machine::Machine machine;
    machine::MachineData data;          ///< Offsets, tools, variables.
    bool has_data = false;              ///< There were files of them, or lines.
    std::vector<std::string> warnings;  ///< Messages: settings not taken over that change positions or times.
    std::vector<std::string> left_out;  ///< Other settings not taken over, by name.
};

}  // namespace gsim::import
