#pragma once

#include <array>
#include <cstddef>

#include "geometry/planar/edge.h"

namespace gsim::geometry {

/// Points that two edges have in common. Where they run on each other: the ends of the common stretch.
struct Meets {
    std::array<Point, 8> points{};
    std::size_t count = 0;

    const Point* begin() const { return points.data(); }
    const Point* end() const { return points.data() + count; }
    /// Drops what is nearer than kSamePoint_mm to a point that is there already.
    void add(Point point);
};

/// Where two edges meet, each counting kSamePoint_mm further than it goes.
Meets meets(const Edge& a, const Edge& b);

}  // namespace gsim::geometry
