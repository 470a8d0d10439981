#pragma once

#include <string>
#include <vector>

#include "geometry/planar/contour.h"

namespace gsim::geometry {

/// What came of joining pieces end to end.
struct Chained {
    std::vector<Contour> closed;
    std::vector<Contour> open;  ///< What nothing could be found for.
    bool crowded = false;       ///< So many ends in one place that no order can be seen in them.
};

/// Joins pieces whose ends lie within `tolerance_mm` of each other, the nearest first; those that fit exactly
/// come before all others. A gap is closed by moving the end of a piece. Takes O(n log n).
Chained chain(std::vector<Contour> pieces, double tolerance_mm);

/// Removes edges without a length; a contour may be left without any.
void drop_short_edges(Contour& contour);

}  // namespace gsim::geometry
