#pragma once

#include <optional>
#include <vector>

#include "geometry/planar/contour.h"

namespace gsim::geometry {

/// A part of an offset curve, with its sense.
struct DirectedPart {
    Edge edge;
    std::uint32_t source = 0;
};

/// No part is cut shorter than this.
inline constexpr double kShortestPart_mm = 1e-5;

struct Stitched {
    std::vector<Contour> contours;
    std::optional<Point> loose;  ///< An end of parts, longer than rounding explains, that belong to none.
};

/// Joins parts, end to start, to closed contours. What ends in nothing is left out, and so are contours
/// without a width.
Stitched stitch(const std::vector<DirectedPart>& parts);

}  // namespace gsim::geometry
