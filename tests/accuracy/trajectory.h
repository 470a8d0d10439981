#pragma once

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::accuracy {

/// Where X, Y and Z stand at a time.
struct Sample {
    double t_s = 0;
    std::array<double, 3> at_mm{};
};

/// Samples in order of time.
using Trajectory = std::vector<Sample>;

/// Reads CSV with a header: time `t` or `t_s`, axes `x`, `y`, `z` or `x_mm`, `y_mm`, `z_mm`; other columns
/// are passed over. The error says which line cannot be understood, also where time goes back.
tl::expected<Trajectory, std::string> read_trajectory(std::istream& csv);

/// The place at a time, on the line between the samples around it; before the first and behind the last
/// sample the place of that one. `trajectory` is not empty.
std::array<double, 3> place_at_mm(const Trajectory& trajectory, double t_s);

}  // namespace gsim::accuracy
