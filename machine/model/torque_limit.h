#pragma once

#include <optional>
#include <string>

#include "machine/model/machine.h"

namespace gsim::machine {

/// Whether the peaks of its motors limit the accelerations of a machine (`limit = "torque"`).
bool is_torque_limited(const Machine& machine);

/// Whether an axis says what its motor brings up.
bool has_motor(const Axis& axis);

/// Why that cannot be, as a sentence that names the key; nothing where it can, or is not asked for.
std::optional<std::string> find_torque_limit_fault(const Machine& machine);

}  // namespace gsim::machine
