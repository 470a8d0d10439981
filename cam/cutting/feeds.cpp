#include "cam/cutting/feeds.h"

#include <algorithm>

namespace gsim::cutting {

using geometry::Edge;

namespace {

constexpr double kWorthIt = 0.999;     // a smaller change of feed is ignored
constexpr double kShortest_mm = 0.01;  // parts of edges

double corner_feed(const Edge& before, const Edge& after, const CutRules& rules) {
    if (!rules.feed_in_corner_mm_min) return rules.speed_mm_min;
    const geometry::Point a = end_tangent(before);
    const geometry::Point b = start_tangent(after);
    return rules.feed_in_corner_mm_min(std::atan2(cross(a, b), dot(a, b)));
}

// Adds an edge between two corners, in up to three parts.
void add_edge(const Edge& edge, std::uint32_t source, double first_feed, double last_feed,
              const CutRules& rules, std::vector<FedEdge>& result) {
    const double own = feed_on_mm_min(edge, rules);
    const double zone = std::min(1.0, rules.corner_zone_mm / length_mm(edge));
    double first_end = first_feed < kWorthIt * own ? zone : 0;
    double last_begin = last_feed < kWorthIt * own ? 1 - zone : 1;
    // Zones that overlap share the edge.
    if (first_end > last_begin) first_end = last_begin = first_end / (first_end + 1 - last_begin);
    const double least = kShortest_mm / length_mm(edge);
    if (first_end < least) first_end = 0;
    if (1 - last_begin < least) last_begin = 1;
    if (last_begin - first_end < least && first_end > 0) first_end = last_begin;
    if (first_end > 0) result.push_back({part_of(edge, 0, first_end), std::min(first_feed, own), source});
    if (first_end < last_begin) result.push_back({part_of(edge, first_end, last_begin), own, source});
    if (last_begin < 1) result.push_back({part_of(edge, last_begin, 1), std::min(last_feed, own), source});
}

}  // namespace

double feed_on_mm_min(const Edge& edge, const CutRules& rules) {
    if (!is_arc(edge) || !rules.feed_on_arc_mm_min) return rules.speed_mm_min;
    return std::min(rules.speed_mm_min, rules.feed_on_arc_mm_min(radius_mm(edge)));
}

std::vector<FedEdge> with_feeds(const geometry::Contour& loop, const CutRules& rules) {
    std::vector<FedEdge> result;
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
