#include "cam/cutting/feeds.h"

#include <algorithm>

namespace gsim::cutting {

using geometry::Edge;

namespace {

constexpr double kFeedChangeThreshold = 0.999;  // a smaller change of feed is ignored
constexpr double kMinLength_mm = 0.01;          // parts of edges

double corner_feed(const Edge& before, const Edge& after, const CutRules& rules) {
    if (!rules.feed_in_corner_mm_min) return rules.speed_mm_min;
    const geometry::Point a = end_tangent(before);
    const geometry::Point b = start_tangent(after);
    return rules.feed_in_corner_mm_min(std::atan2(cross(a, b), dot(a, b)));
}

// Adds an edge between two corners, in up to three parts.
void add_edge(const Edge& edge, std::uint32_t source, double first_feed, double last_feed,
              const CutRules& rules, std::vector<FeedSegment>& result) {
    const double edge_feed = edge_feed_mm_min(edge, rules);
    const double zone = std::min(1.0, rules.corner_zone_mm / length_mm(edge));
    double first_zone_end = first_feed < kFeedChangeThreshold * edge_feed ? zone : 0;
    double last_zone_begin = last_feed < kFeedChangeThreshold * edge_feed ? 1 - zone : 1;
    // Zones that overlap share the edge.
    if (first_zone_end > last_zone_begin)
        first_zone_end = last_zone_begin = first_zone_end / (first_zone_end + 1 - last_zone_begin);
    const double min = kMinLength_mm / length_mm(edge);
    if (first_zone_end < min) first_zone_end = 0;
    if (1 - last_zone_begin < min) last_zone_begin = 1;
    if (last_zone_begin - first_zone_end < min && first_zone_end > 0) first_zone_end = last_zone_begin;
    if (first_zone_end > 0)
        result.push_back({sub_edge(edge, 0, first_zone_end), std::min(first_feed, edge_feed), source});
    if (first_zone_end < last_zone_begin)
        result.push_back({sub_edge(edge, first_zone_end, last_zone_begin), edge_feed, source});
    if (last_zone_begin < 1)
        result.push_back({sub_edge(edge, last_zone_begin, 1), std::min(last_feed, edge_feed), source});
}

}  // namespace

double edge_feed_mm_min(const Edge& edge, const CutRules& rules) {
    if (!is_arc(edge) || !rules.feed_on_arc_mm_min) return rules.speed_mm_min;
    return std::min(rules.speed_mm_min, rules.feed_on_arc_mm_min(radius_mm(edge)));
}

std::vector<FeedSegment> assign_feeds(const geometry::Contour& loop, const CutRules& rules) {
    std::vector<FeedSegment> result;
    result.reserve(loop.edges());
    const std::size_t count = loop.edges();
    if (count == 0) return result;
    double first = corner_feed(loop.edge(count - 1), loop.edge(0), rules);
    for (std::size_t i = 0; i < count; ++i) {
        const double last = corner_feed(loop.edge(i), loop.edge(loop.next(i)), rules);
        add_edge(loop.edge(i), loop.vertices[i].source, first, last, rules, result);
        first = last;
    }
    return result;
}

}  // namespace gsim::cutting
