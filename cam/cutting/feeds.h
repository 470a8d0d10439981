#pragma once

#include <vector>

#include "cam/cutting/cut_rules.h"
#include "geometry/planar/contour.h"

namespace gsim::cutting {

/// A part of a cut at one feed.
struct FeedSegment {
    geometry::Edge edge;
    double feed_mm_min = 0;
    std::uint32_t source = 0;  ///< geometry::Vertex::source
};

/// Returns the edges of a closed loop in order, each with its feed: slower on arcs, and on both sides of
/// corners. Edges are divided for that.
std::vector<FeedSegment> assign_feeds(const geometry::Contour& loop, const CutRules& rules);

/// Returns the feed on a single edge.
double edge_feed_mm_min(const geometry::Edge& edge, const CutRules& rules);

}  // namespace gsim::cutting
