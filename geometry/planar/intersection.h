#pragma once

#include <array>
#include <cstddef>

#include "geometry/planar/edge.h"

namespace gsim::geometry {

/// Common points of two edges. If they overlap: the ends of the common stretch.
struct Intersections {
    std::array<Point, 8> points{};
    std::size_t count = 0;

    const Point* begin() const { return points.data(); }
    const Point* end() const { return points.data() + count; }
    /// Adds a point, unless it is nearer than kPointTolerance_mm to an existing one.
    void add(Point point);
};

/// Returns the points where two edges meet; each edge is extended by kPointTolerance_mm.
Intersections intersections(const Edge& a, const Edge& b);

}  // namespace gsim::geometry
