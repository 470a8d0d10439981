#pragma once

#include <vector>

#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// Where a contour is left uncut so that what it goes round stays where it is.
struct Bridges {
    int count = 0;        ///< Of each contour, at even distances, none where it begins.
    double width_mm = 0;  ///< Of what stays, along the edge.
};

/// The pieces of a way between its bridges, in order; the whole way where there are none. Each bridge is as
/// wide as it shall be and the jet besides. Empty where there is no room for so many.
std::vector<std::vector<JetPoint>> pieces_between(const std::vector<JetPoint>& way, const Bridges& bridges,
                                                  double kerf_mm);

}  // namespace gsim::surface
