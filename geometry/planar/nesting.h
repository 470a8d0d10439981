#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/planar/contour.h"

namespace gsim::geometry {

/// Position of a contour among others.
struct NestingLevel {
    std::optional<std::size_t> parent;  ///< The smallest contour around it.
    std::size_t depth = 0;              ///< Number of contours around it: even, the outside of a part.
};

/// Returns the nesting of closed contours that neither cross nor touch.
std::vector<NestingLevel> find_nesting(std::span<const Contour> contours);

/// True if a point is inside of a closed contour.
bool inside(const Contour& contour, Point point);

}  // namespace gsim::geometry
