#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/planar/point.h"

namespace gsim::cutting {

/// A stop to visit: the tour arrives at one point and leaves from another.
struct Stop {
    geometry::Point entry, exit;
};

/// Returns a short path through all stops from `start`, then on to `end` if given: each stop's number once.
/// It starts with the nearest neighbour. Then it reverses parts of the path (2-opt; Croes, 1958) and moves
/// parts (Or-opt; Or, 1976) while that makes it shorter. The number of stops limits the number of steps.
std::vector<std::size_t> short_tour(std::span<const Stop> stops, geometry::Point start,
                                    std::optional<geometry::Point> end);

/// Returns the length of the paths between stops in this order.
double tour_length_mm(std::span<const Stop> stops, std::span<const std::size_t> order, geometry::Point start,
                      std::optional<geometry::Point> end);

}  // namespace gsim::cutting
