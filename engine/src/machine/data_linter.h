#pragma once

#include <optional>
#include <string>
#include <vector>

#include "machine/data/machine_data_document.h"

namespace gsim::engine {

/// Returns lint warnings for readable machine data, as "file:line:column: warning: message" each: aliases
/// that the controller would reject, points and walls beyond the ranges of the machine (if it is known),
/// zones that no code switches on.
std::vector<std::string> lint_machine_data(const machine::MachineDataDocument& document,
                                           const std::string& file_name,
                                           const std::optional<machine::Machine>& machine);

}  // namespace gsim::engine
