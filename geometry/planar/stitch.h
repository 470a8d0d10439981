#pragma once

#include <optional>
#include <vector>

#include "geometry/planar/contour.h"

namespace gsim::geometry {

/// A part of an offset curve, with its direction.
struct DirectedPart {
    Edge edge;
    std::uint32_t source = 0;
};

/// Min length to which a part is cut.
inline constexpr double kMinPartLength_mm = 1e-5;

struct StitchResult {
    std::vector<Contour> contours;
    std::optional<Point> loose_end;  ///< An end of unmatched parts that are longer than rounding explains.
};

/// Joins parts, end to start, to closed contours. Dead ends are omitted, and so are contours without a width.
StitchResult stitch(const std::vector<DirectedPart>& parts);

}  // namespace gsim::geometry
