#include "geometry/planar/offset.h"

#include <utility>

#include "geometry/planar/box_tree.h"
#include "geometry/planar/intersection.h"
#include "geometry/planar/stitch.h"

namespace gsim::geometry {

namespace {

constexpr double kDistanceTolerance_mm = 1e-6;  // how much nearer than the distance a part may be by rounding

// Returns the curvature, above 0 to the left.
double curvature(const Edge& edge) {
    return is_arc(edge) ? std::copysign(1 / radius_mm(edge), edge.bulge) : 0;
}

// The curve at a distance d to the right, in parts that need not meet.
class RawOffset {
  public:
    RawOffset(const Contour& contour, double d) : contour_(contour), d_(d) {
        parts_.reserve(2 * contour.edges());
        const std::size_t count = contour.edges();
        for (std::size_t i = 0; i < count; ++i) {
            offset_edge(i);
            round_corner(i);
        }
    }

    std::vector<DirectedPart> release() { return std::move(parts_); }

  private:
    void offset_edge(std::size_t i) {
        const Edge edge = contour_.edge(i);
        const Point start = edge.start + d_ * right_normal(start_tangent(edge));
        const Point end = edge.end + d_ * right_normal(end_tangent(edge));
        // In a hollow that is narrower than the distance, no point is far enough off.
        const bool is_concave = is_arc(edge) && edge.bulge < 0;
        if (is_concave && radius_mm(edge) - d_ <= 10 * kPointTolerance_mm) return;
        add({start, end, is_arc(edge) ? edge.bulge : 0}, contour_.vertices[i].source);
    }

    // Adds the arc about the corner at the end of edge i, if the contour turns to the left.
    void round_corner(std::size_t i) {
        const std::size_t next = contour_.next(i);
        const Edge edge = contour_.edge(i);
        const Edge next_edge = contour_.edge(next);
        const Point before = end_tangent(edge);
        const Point after = start_tangent(next_edge);
        const double turn = cross(before, after);
        // In a cusp the directions do not give the sense of the turn, but the curvatures of both edges do.
        const bool back = dot(before, after) < 0 && std::abs(turn) < 1e-6;
        const bool left = back ? curvature(edge) + curvature(next_edge) < 0 : turn > 0;
        if (!left) return;
        const double angle = back ? std::numbers::pi : std::atan2(turn, dot(before, after));
        const Point corner = contour_.vertices[next].position;
        add({corner + d_ * right_normal(before), corner + d_ * right_normal(after), std::tan(angle / 4)},
            contour_.vertices[i].source);
    }

    void add(const Edge& edge, std::uint32_t source) {
        if (distance(edge.start, edge.end) > kPointTolerance_mm) parts_.push_back({edge, source});
    }

    const Contour& contour_;
    double d_;
    std::vector<DirectedPart> parts_;
};

// Cuts parts at the points where they meet others.
std::vector<DirectedPart> cut(const std::vector<DirectedPart>& parts) {
    std::vector<Box> boxes;
    boxes.reserve(parts.size());
    for (const DirectedPart& part : parts) boxes.push_back(bounding_box(part.edge));
    const BoxTree tree(boxes);
    std::vector<DirectedPart> result;
    result.reserve(parts.size() + parts.size() / 2);
    std::vector<double> shares;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Edge& edge = parts[i].edge;
        shares.assign(1, 0.0);
        tree.visit(boxes[i].expanded(kPointTolerance_mm), [&](std::size_t j) {
            if (j == i) return true;
            for (const Point& location : intersections(edge, parts[j].edge))
                shares.push_back(share_at(edge, location));
            return true;
        });
        std::sort(shares.begin(), shares.end());
        const double min = kMinPartLength_mm / length_mm(edge);
        double from = 0;
        for (const double share : shares) {
            if (share - from < min || 1 - share < min) continue;
            result.push_back({sub_edge(edge, from, share), parts[i].source});
            from = share;
        }
        result.push_back({sub_edge(edge, from, 1), parts[i].source});
    }
    return result;
}

// Removes parts that are nearer to the contour than d.
void remove_too_near(std::vector<DirectedPart>& parts, const Contour& contour, double d) {
    const BoxTree tree(edge_boxes(contour));
    std::erase_if(parts, [&](const DirectedPart& part) {
        const Point middle = point_at(part.edge, 0.5);
        bool near = false;
        tree.visit(Box{middle, middle}.expanded(d), [&](std::size_t i) {
            near = distance_mm(contour.edge(i), middle) < d - kDistanceTolerance_mm;
            return !near;
        });
        return near;
    });
}

tl::expected<std::vector<Contour>, OffsetError> offset_right(const Contour& contour, double d) {
    // If three or more parts meet in one point to the last digit, a slightly longer distance separates them.
    constexpr double kDistanceFactors[] = {1, 1 + 3e-7, 1 - 7e-7, 1 + 5e-6};
    StitchResult stitch_result;
    for (const double factor : kDistanceFactors) {
        std::vector<DirectedPart> parts = cut(RawOffset(contour, d * factor).release());
        remove_too_near(parts, contour, d * factor);
        stitch_result = stitch(parts);
        if (!stitch_result.loose_end) return std::move(stitch_result.contours);
    }
    return tl::unexpected(OffsetError{{"the offset does not close"}, *stitch_result.loose_end});
}

}  // namespace

tl::expected<std::vector<Contour>, OffsetError> offset(const Contour& contour, double distance_mm) {
    if (distance_mm == 0) return std::vector<Contour>{contour};
    if (distance_mm > 0) return offset_right(contour, distance_mm);
    Contour reversed_contour = contour;
    reverse(reversed_contour);
    auto result = offset_right(reversed_contour, -distance_mm);
    if (result) {
        for (Contour& part : *result) reverse(part);
    }
    return result;
}

}  // namespace gsim::geometry
