#pragma once

#include <vector>

#include "machine/model/machine_parameter.h"

namespace gsim::calibrate {

/// Fitted parameter of a machine file. Its logarithm is fitted: all are above 0.
struct Parameter {
    machine::MachineParameter parameter_id;
    double first = 0;  ///< Start value of the fit.
    double min = 0;
    double max = 0;
};

/// Open parameters of a machine in addition to those of its controller's rules.
struct FreeParameters {
    bool each_axis = false;  ///< Separate parameters for each axis, if axes begin with equal values.
    bool speeds = false;     ///< Speeds of axes and of the path.

    bool operator==(const FreeParameters&) const = default;
};

/// Returns the open parameters of a machine, by its controller's rules:
/// - accelerations (combined for axes with the same initial value, unless each is requested), and jerks if
///   they are limited;
/// - corner parameters, the share of curves, the time for a block;
/// - waits at stops, and times of words if they take some.
/// Bounds are factors of 100 around the machine's values; waits that it lacks begin at 10 ms. Unlimited
/// values (inf) are not fitted.
std::vector<Parameter> free_parameters(const machine::Machine& machine, const FreeParameters& open);

/// Returns the machine with these values of parameters, in their order.
machine::Machine with_values(machine::Machine machine, const std::vector<Parameter>& parameters,
                             const std::vector<double>& values);

}  // namespace gsim::calibrate
