#pragma once

#include <optional>
#include <string>

#include "base/error.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// True if the peaks of its motors limit the accelerations of a machine (`limit = "torque"`).
bool is_torque_limited(const Machine& machine);

/// True if an axis gives the force or torque of its motor.
bool has_motor(const Axis& axis);

/// Returns an error that names the key if that is requested and impossible.
std::optional<Error> find_torque_limit_error(const Machine& machine);

}  // namespace gsim::machine
