#pragma once

#include <optional>
#include <string>
#include <vector>

#include "machine/model/machine.h"

namespace gsim::machine {

/// A parameter of a machine's motion that can be known inexactly: a key of the file, of some axes together,
/// of the path or of the controller.
using MachineParameter = CalibratedParameter;

/// Returns words for it: "axes X, Y: max_acceleration_mm_s2".
std::string parameter_name(const MachineParameter& parameter_id);

/// Returns its value, in the units of the file; for several axes, that of the first. Returns nothing if the
/// machine has no such parameter.
std::optional<double> parameter_value(const MachineParameter& parameter_id, const Machine& machine);

/// Sets it for all its axes; the machine must have the parameter.
void set_value(const MachineParameter& parameter_id, double value, Machine& machine);

}  // namespace gsim::machine
