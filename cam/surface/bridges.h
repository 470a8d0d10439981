#pragma once

#include <vector>

#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// Uncut bridges of a contour that keep the enclosed material in position.
struct Bridges {
    int count = 0;        ///< For each contour, equidistant, none at its start.
    double width_mm = 0;  ///< Uncut length along the edge.
};

/// Returns the parts of a path between its bridges, in order; the complete path without bridges. Each gap is
/// as long as the bridge width plus the jet's width. Returns nothing if the path is too short for so many.
std::vector<std::vector<JetPoint>> split_at_bridges(const std::vector<JetPoint>& jet_path,
                                                    const Bridges& bridges, double kerf_mm);

}  // namespace gsim::surface
