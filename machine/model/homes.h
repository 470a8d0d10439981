#pragma once

#include <map>

#include "machine/data/machine_data.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// Home positions 2 to 4 by number, in machine coordinates: `stored` ones, as machine data has them, and
/// where these have no value for an axis, that of the machine file.
std::map<int, AxisValues> further_homes(const Machine& machine, const std::map<int, AxisValues>& stored);

}  // namespace gsim::machine
