#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "geometry/planar/contour.h"

namespace gsim::geometry {

/// Where and why there is no offset.
struct OffsetFault {
    Point place;
    std::string sentence;
};

/// The curve at a distance to the right of a closed contour that does not cross itself, corners rounded; to
/// the left where the distance is below 0. Exact: lines and arcs stay lines and arcs. A contour may fall into
/// several, or into none where there is no room for it. A counter-clockwise contour grows.
///
/// Each edge is moved by itself, corners that open get an arc, all are cut where they meet, and of the parts
/// those are kept that nothing of the contour is nearer to than the distance.
tl::expected<std::vector<Contour>, OffsetFault> offset(const Contour& contour, double distance_mm);

}  // namespace gsim::geometry
