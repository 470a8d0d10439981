#pragma once

#include <string>
#include <vector>

#include "geometry/planar/contour.h"

namespace gsim::geometry {

/// Result of joining parts end to end.
struct ChainResult {
    std::vector<Contour> closed;
    std::vector<Contour> open;  ///< Parts without a match.
    bool is_ambiguous = false;  ///< Too many ends at one position to find an order of them.
};

/// Joins parts whose ends are within `tolerance_mm` of each other, the nearest first; those that fit exactly
/// come before all others. A gap is closed by moving the end of a part. Takes O(n log n).
ChainResult chain(std::vector<Contour> drawn_contours, double tolerance_mm);

/// Removes edges without a length; a contour may have none left.
void remove_short_edges(Contour& contour);

}  // namespace gsim::geometry
