#pragma once

#include <vector>

#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// Marks the points of a closed path within a zone on either side of a corner that closes (one that opens is
/// an arc). Adds points at the beginning and end of zones. `zone_mm`: along the path of the jet's center; 0:
/// no zones.
void mark_corners(std::vector<JetPoint>& points, const JetShape& jet, double zone_mm);

}  // namespace gsim::surface
