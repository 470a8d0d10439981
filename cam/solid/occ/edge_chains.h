#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "cam/solid/occ/wall_contour.h"

namespace gsim::solid {

/// Edges one behind the other; closed where the last ends where the first begins.
struct EdgeChain {
    std::vector<std::size_t> edges;  ///< Indices.
    bool is_closed = false;
};

/// Joins edges where the end of one is the begin of another. The error is a sentence: three of them that
/// meet.
tl::expected<std::vector<EdgeChain>, std::string> chain(const std::vector<EdgeAlone>& edges);

/// Whether the way round a closed chain has its waste within: seen from outside, it goes round clockwise.
bool is_hole(const WallContour& closed);

}  // namespace gsim::solid
