#pragma once

#include <vector>

#include "calibrate/geometry/geometry_fit.h"

namespace gsim::calibrate {

/// How far two slides are from square to each other, where the file has them so: um of the one's way along
/// the other's for each m; above 0 where they go less than 90 degrees apart. As the tool goes against the
/// work, with all joints at zero.
struct Squareness {
    char first = 'X';
    char second = 'Y';
    double value_um_m = 0;
    double spread_um_m = 0;  ///< One standard deviation.
};

/// Of each pair of slides. `nominal` is the machine that was fitted.
std::vector<Squareness> squareness_of(const machine::Machine& nominal, const GeometryFit& fit);

}  // namespace gsim::calibrate
