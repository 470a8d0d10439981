#pragma once

#include <string>
#include <vector>

#include "machine/data/machine_data.h"
#include "machine/model/machine.h"

namespace gsim::import {

/// What the settings of a control became.
struct Imported {
    machine::Machine machine;
    machine::MachineData data;          ///< Offsets, tools, variables.
    bool has_data = false;              ///< There were files of them, or lines.
    std::vector<std::string> warnings;  ///< What is not taken over, and changes places or times: sentences.
    std::vector<std::string> left_out;  ///< All else that is not taken over, by name.
};

}  // namespace gsim::import
