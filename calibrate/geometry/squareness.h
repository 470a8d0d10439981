#pragma once

#include <vector>

#include "calibrate/geometry/geometry_fit.h"

namespace gsim::calibrate {

/// Deviation of two slides from square, if they are square in the file: um of one slide's travel along the
/// other for each m. It is above 0 if they are less than 90 degrees apart. It is for the motion of the tool
/// relative to the work, with all joints at zero.
struct Squareness {
    char first = 'X';
    char second = 'Y';
    double value_um_m = 0;
    double standard_deviation_um_m = 0;  ///< One standard deviation.
};

/// Returns the squareness of each pair of slides. `nominal` is the machine that was fitted.
std::vector<Squareness> compute_squareness(const machine::Machine& nominal, const GeometryFit& fit);

}  // namespace gsim::calibrate
