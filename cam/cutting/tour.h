#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/planar/point.h"

namespace gsim::cutting {

/// Something to be visited: one comes in at a point and leaves from another.
struct Stop {
    geometry::Point entry, exit;
};

/// A short way through all stops from `start`, then on to `end` if there is one: each stop's number once.
/// Nearest neighbour, then parts of the way are turned round (2-opt; Croes, 1958) and moved (Or-opt; Or,
/// 1976) while that makes it shorter, within a number of steps that the number of stops bounds.
std::vector<std::size_t> short_tour(std::span<const Stop> stops, geometry::Point start,
                                    std::optional<geometry::Point> end);

/// The length of the ways between stops in this order.
double tour_length_mm(std::span<const Stop> stops, std::span<const std::size_t> order, geometry::Point start,
                      std::optional<geometry::Point> end);

}  // namespace gsim::cutting
