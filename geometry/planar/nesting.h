#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/planar/contour.h"

namespace gsim::geometry {

/// Where a contour lies among others.
struct Nest {
    std::optional<std::size_t> parent;  ///< The smallest contour around it.
    std::size_t depth = 0;              ///< How many contours are around it: even, the outside of a part.
};

/// For closed contours that neither cross nor touch.
std::vector<Nest> nest(std::span<const Contour> contours);

/// Whether a point lies inside of a closed contour.
bool inside(const Contour& contour, Point point);

}  // namespace gsim::geometry
