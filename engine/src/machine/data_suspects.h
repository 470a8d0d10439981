#pragma once

#include <optional>
#include <string>
#include <vector>

#include "machine/data/machine_data_document.h"

namespace gsim::engine {

/// What is suspect in machine data that can be read, as "file:line:column: warning: sentence" each: aliases
/// that the control would refuse, points and walls beyond the ranges of the machine (where there is one),
/// zones that nothing switches on.
std::vector<std::string> data_suspects(const machine::MachineDataDocument& document,
                                       const std::string& file_name,
                                       const std::optional<machine::Machine>& machine);

}  // namespace gsim::engine
