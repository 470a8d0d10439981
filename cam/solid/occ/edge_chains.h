#pragma once

#include <vector>

#include "base/error.h"
#include "cam/solid/occ/wall_contour.h"

namespace gsim::solid {

/// Consecutive edges; closed if the last ends at the beginning of the first.
struct EdgeChain {
    std::vector<std::size_t> edges;  ///< Indices.
    bool is_closed = false;
};

/// Joins edges if the end of one is the beginning of another. The error is a message: three edges that meet.
Result<std::vector<EdgeChain>> chain(const std::vector<ChainEdge>& edges);

/// Returns true if a closed chain has its waste inside: seen from outside, it runs clockwise.
bool is_hole(const WallContour& closed);

}  // namespace gsim::solid
