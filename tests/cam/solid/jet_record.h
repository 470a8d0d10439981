#pragma once

// Path of a jet in a run, and what it left of a part.

#include <Eigen/Core>
#include <string>
#include <vector>

namespace gsim::solid::models {

/// Jet at a moment: its TCP, and the direction from there up to the nozzle.
struct Jet {
    Eigen::Vector3d tcp_mm, axis;
};

/// Returns the part with the jet on, from M08 to M09 in the lines of the program, of the trajectory that
/// gsim-run writes. The machine is like af5.toml (the TCP at X, Y, Z, turned by B, tilted by C). Positions
/// are counted from an origin.
std::vector<Jet> read_jets(const std::string& csv, const std::string& program,
                           const Eigen::Vector3d& origin_mm);

/// Deviation of the edge that the jets cut from the edge of these points. The nearest part of a jet must be
/// half of the kerf from each point. The values are extremes over all points, above 0 if the jet left too
/// much, below if it cut into the part.
struct Deviation {
    double min_mm = 0, greatest_mm = 0;
};
Deviation deviation(const std::vector<Eigen::Vector3d>& points, const std::vector<Jet>& jets, double kerf_mm);

}  // namespace gsim::solid::models
