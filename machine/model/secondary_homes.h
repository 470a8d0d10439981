#pragma once

#include <map>

#include "machine/data/machine_data.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// Returns home positions 2 to 4 by number, in machine coordinates: those in `stored`, as machine data has
/// them. If these have no value for an axis, that of the machine file is used.
std::map<int, AxisValues> secondary_homes(const Machine& machine, const std::map<int, AxisValues>& stored);

}  // namespace gsim::machine
