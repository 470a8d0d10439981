#pragma once

// Where a jet went in a run, and what it left of a part.

#include <Eigen/Core>
#include <string>
#include <vector>

namespace gsim::solid::models {

/// A jet at a moment: its tip, and the direction from there up to the nozzle.
struct Jet {
    Eigen::Vector3d tip_mm, axis;
};

/// Of the trajectory that gsim-run writes of a machine like af5.toml (the tip at X, Y, Z, turned by B, tilted
/// by C) what is driven with the jet on: from M08 to M09 in the lines of the program. Places are counted from
/// an origin.
std::vector<Jet> read_jets(const std::string& csv, const std::string& program,
                           const Eigen::Vector3d& origin_mm);

/// How far the edge that the jets cut is off the edge that these points are of: what is nearest of a jet to
/// each point has to be half of the kerf away. Greatest over all points, above 0 where the jet left too much,
/// below where it cut into the part.
struct Deviation {
    double least_mm = 0, greatest_mm = 0;
};
Deviation deviation(const std::vector<Eigen::Vector3d>& points, const std::vector<Jet>& jets, double kerf_mm);

}  // namespace gsim::solid::models
