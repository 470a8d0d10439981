#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "base/error.h"
#include "geometry/planar/contour.h"

namespace gsim::geometry {

/// Position and reason of a missing offset.
struct OffsetError : Error {
    Point location;
};

/// Returns the curve at a distance to the right of a closed contour that does not cross itself, with rounded
/// corners; to the left if the distance is below 0. Exact: lines and arcs stay lines and arcs. A contour may
/// split into several, or disappear if the space is too narrow. A counter-clockwise contour grows.
///
/// Each edge is moved by itself, and corners that open get an arc. All parts are cut where they meet. Parts
/// are kept if no part of the contour is nearer to them than the distance.
tl::expected<std::vector<Contour>, OffsetError> offset(const Contour& contour, double distance_mm);

}  // namespace gsim::geometry
