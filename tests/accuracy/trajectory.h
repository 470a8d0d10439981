#pragma once

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

#include "base/error.h"

namespace gsim::accuracy {

/// Position of X, Y and Z at a time.
struct Sample {
    double t_s = 0;
    std::array<double, 3> at_mm{};
};

/// Samples in order of time.
using Trajectory = std::vector<Sample>;

/// Reads CSV with a header: time `t` or `t_s`, axes `x`, `y`, `z` or `x_mm`, `y_mm`, `z_mm`; other columns
/// are ignored. The error names the line that cannot be parsed, or in which time runs backwards.
Result<Trajectory> read_trajectory(std::istream& csv);

/// Returns the position at a time, on the line between the samples around it. Before the first and after the
/// last sample it is the position of that sample. `trajectory` is not empty.
std::array<double, 3> place_at_mm(const Trajectory& trajectory, double t_s);

}  // namespace gsim::accuracy
