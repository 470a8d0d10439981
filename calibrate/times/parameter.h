#pragma once

#include <vector>

#include "machine/model/figure.h"

namespace gsim::calibrate {

/// A figure of a machine file that is fitted. Its logarithm is what is looked for: all are above 0.
struct Parameter {
    machine::Figure figure;
    double first = 0;  ///< Where the fit begins.
    double least = 0;
    double most = 0;
};

/// What of a machine is open, beside what its controller's rules leave open.
struct OpenFigures {
    bool each_axis = false;  ///< Figures of each axis by themselves, where axes begin with the same.
    bool speeds = false;     ///< Speeds of axes and of the path.

    bool operator==(const OpenFigures&) const = default;
};

/// What a machine leaves open, by its controller's rules: accelerations (of axes that have the same one at
/// first together, unless each is asked for), jerks where they are limited, what corners are passed by, the
/// share of curves, the time for a block, waits at stops, and times of words where they take some. Bounds are
/// factors of 100 about what the machine has; waits that it has not begin at 10 ms. Limits that are none
/// (inf) are not fitted.
std::vector<Parameter> open_parameters(const machine::Machine& machine, const OpenFigures& open);

/// The machine with these values of parameters, in their order.
machine::Machine with_values(machine::Machine machine, const std::vector<Parameter>& parameters,
                             const std::vector<double>& values);

}  // namespace gsim::calibrate
