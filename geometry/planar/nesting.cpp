#include "geometry/planar/nesting.h"

#include "geometry/planar/box_tree.h"

namespace gsim::geometry {

namespace {

// True if a ray from the point to the right passes the edge an odd number of times. It counts passes of the
// chord, and one more from between the arc and its chord.
bool ray_crosses(const Edge& edge, Point point) {
    const Point a = edge.start;
    const Point b = edge.end;
    // A point on the line of the chord counts as a little higher, because both tests must see it on one side.
    const double side = cross(b - a, point - a);
    const bool left = side > 0 || (side == 0 && b.x > a.x);
    bool passes = (a.y > point.y) != (b.y > point.y) && left == (b.y > a.y);
    if (!is_arc(edge)) return passes;
    if (left != (edge.bulge > 0) && distance(center(edge), point) < radius_mm(edge)) passes = !passes;
    return passes;
}

// Returns those numbers that occur an odd number of times in a list.
std::vector<std::uint32_t> odd_occurrences(std::vector<std::uint32_t>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    std::vector<std::uint32_t> odd_numbers;
    for (const std::uint32_t number : numbers) {
        if (!odd_numbers.empty() && odd_numbers.back() == number) {
            odd_numbers.pop_back();
        } else {
            odd_numbers.push_back(number);
        }
    }
    return odd_numbers;
}

}  // namespace

std::vector<NestingLevel> find_nesting(std::span<const Contour> contours) {
    std::vector<EdgeId> edges;
    std::vector<Box> boxes;
    std::vector<double> areas;
    areas.reserve(contours.size());
    for (std::size_t c = 0; c < contours.size(); ++c) {
        areas.push_back(std::abs(area_mm2(contours[c])));
        for (std::size_t e = 0; e < contours[c].edges(); ++e) {
            edges.push_back({static_cast<std::uint32_t>(c), static_cast<std::uint32_t>(e)});
            boxes.push_back(bounding_box(contours[c].edge(e)));
        }
    }
    const BoxTree tree(boxes);
    std::vector<NestingLevel> nestings(contours.size());
    std::vector<std::uint32_t> passed;
    for (std::size_t c = 0; c < contours.size(); ++c) {
        if (contours[c].vertices.empty()) continue;
        const Point point = contours[c].vertices.front().position;
        passed.clear();
        tree.visit({point, {HUGE_VAL, point.y}}, [&](std::size_t i) {
            const EdgeId edge = edges[i];
            if (edge.contour != c && ray_crosses(contours[edge.contour].edge(edge.edge), point)) {
                passed.push_back(edge.contour);
            }
            return true;
        });
        for (const std::uint32_t outer_contour : odd_occurrences(passed)) {
            NestingLevel& current_nest = nestings[c];
            ++current_nest.depth;
            if (!current_nest.parent || areas[outer_contour] < areas[*current_nest.parent])
                current_nest.parent = outer_contour;
        }
    }
    return nestings;
}

bool inside(const Contour& contour, Point point) {
    bool odd_numbers = false;
    for (std::size_t i = 0; i < contour.edges(); ++i) odd_numbers ^= ray_crosses(contour.edge(i), point);
    return odd_numbers;
}

}  // namespace gsim::geometry
