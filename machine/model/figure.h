#pragma once

#include <optional>
#include <string>
#include <vector>

#include "machine/model/machine.h"

namespace gsim::machine {

/// A parameter of a machine's motion that can be known inexactly: a key of the file, of some axes together,
/// of the path or of the controller.
using Figure = CalibratedFigure;

/// Returns words for it: "axes X, Y: max_acceleration_mm_s2".
std::string name_of(const Figure& figure);

/// Returns its value, in the units of the file; for several axes, that of the first. Returns nothing if the
/// machine has no such parameter.
std::optional<double> value_of(const Figure& figure, const Machine& machine);

/// Sets it for all its axes; the machine must have the parameter.
void set_value(const Figure& figure, double value, Machine& machine);

}  // namespace gsim::machine
