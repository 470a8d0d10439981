#pragma once

#include <optional>
#include <string>
#include <vector>

#include "machine/model/machine.h"

namespace gsim::machine {

/// A figure of a machine's motion that can be known inexactly: a key of the file, of some axes together, of
/// the path or of the controller.
using Figure = CalibratedFigure;

/// Words for it: "axes X, Y: max_acceleration_mm_s2".
std::string name_of(const Figure& figure);

/// Its value, in the units of the file: of several axes that of the first. Nothing where the machine has no
/// such figure.
std::optional<double> value_of(const Figure& figure, const Machine& machine);

/// Sets it, of all its axes; a figure that the machine has.
void set_value(const Figure& figure, double value, Machine& machine);

}  // namespace gsim::machine
