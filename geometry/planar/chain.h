#pragma once

#include <string>
#include <vector>

#include "geometry/planar/contour.h"

namespace gsim::geometry {

/// Result of joining parts end to end.
struct Chained {
    std::vector<Contour> closed;
    std::vector<Contour> open;  ///< Parts without a match.
    bool crowded = false;       ///< Too many ends at one position to find an order of them.
};

/// Joins parts whose ends are within `tolerance_mm` of each other, the nearest first; those that fit exactly
/// come before all others. A gap is closed by moving the end of a part. Takes O(n log n).
Chained chain(std::vector<Contour> pieces, double tolerance_mm);

/// Removes edges without a length; a contour may have none left.
void drop_short_edges(Contour& contour);

}  // namespace gsim::geometry
