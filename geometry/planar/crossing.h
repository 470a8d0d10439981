#pragma once

#include <optional>
#include <span>

#include "geometry/planar/contour.h"

namespace gsim::geometry {

/// Two edges that meet although they should not.
struct Crossing {
    Point location;
    std::size_t contour_a = 0, edge_a = 0;
    std::size_t contour_b = 0, edge_b = 0;
};

/// Returns the first position where closed contours cross or touch themselves or each other. Neighbouring
/// edges that leave their common corner nearer to each other than `tolerance_mm` (a tangent that was rounded)
/// do not cross.
std::optional<Crossing> find_crossing(std::span<const Contour> contours, double tolerance_mm);

/// Returns the same, but contours of one group, by their numbers in `groups`, are not compared.
std::optional<Crossing> find_crossing_between(std::span<const Contour> contours,
                                              std::span<const std::size_t> groups);

}  // namespace gsim::geometry
