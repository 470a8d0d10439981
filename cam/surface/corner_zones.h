#pragma once

#include <vector>

#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// Marks the points of a closed way that are within a zone before or behind a corner that closes (one that
/// opens is an arc), and adds points where zones begin and end. `zone_mm`: along the way of the jet's middle;
/// 0: there is none.
void mark_corners(std::vector<JetPoint>& points, const JetShape& jet, double zone_mm);

}  // namespace gsim::surface
