#include "geometry/planar/crossing.h"

#include "geometry/planar/box_tree.h"
#include "geometry/planar/intersection.h"

namespace gsim::geometry {

namespace {

class CrossingSearch {
  public:
    CrossingSearch(std::span<const Contour> contours, double tolerance_mm,
                   std::span<const std::size_t> groups)
        : contours_(contours), tolerance_mm_(tolerance_mm), groups_(groups) {
        std::size_t count = 0;
        for (const Contour& contour : contours) count += contour.edges();
        edge_ids_.reserve(count);
        boxes_.reserve(count);
        for (std::size_t c = 0; c < contours.size(); ++c) {
            for (std::size_t e = 0; e < contours[c].edges(); ++e) {
                edge_ids_.push_back({static_cast<std::uint32_t>(c), static_cast<std::uint32_t>(e)});
                boxes_.push_back(bounding_box(contours[c].edge(e)));
            }
        }
        tree_ = BoxTree(boxes_);
    }

    std::optional<Crossing> run() const {
        std::optional<Crossing> found;
        for (std::size_t i = 0; i < edge_ids_.size() && !found; ++i) {
            tree_.visit(boxes_[i].expanded(kPointTolerance_mm), [&](std::size_t j) {
                if (j > i) found = between(edge_ids_[i], edge_ids_[j]);
                return !found;
            });
        }
        return found;
    }

  private:
    std::optional<Crossing> between(EdgeId a, EdgeId b) const {
        if (!groups_.empty() && groups_[a.contour] == groups_[b.contour]) return {};
        const Edge edge_a = edge(a);
        const Edge edge_b = edge(b);
        for (const Point& location : intersections(edge_a, edge_b)) {
            if (!belongs(a, b, edge_a, edge_b, location)) {
                return Crossing{location, a.contour, a.edge, b.contour, b.edge};
            }
        }
        return {};
    }

    Edge edge(EdgeId id) const { return contours_[id.contour].edge(id.edge); }

    // True if neighbours may meet at this position.
    bool belongs(EdgeId a, EdgeId b, const Edge& edge_a, const Edge& edge_b, Point location) const {
        if (a.contour != b.contour) return false;
        const Contour& contour = contours_[a.contour];
        return (contour.next(a.edge) == b.edge && is_at_corner(edge_a, edge_b, location)) ||
               (contour.next(b.edge) == a.edge && is_at_corner(edge_b, edge_a, location));
    }

    bool is_at_corner(const Edge& before, const Edge& after, Point location) const {
        if (distance(location, after.start) <= 10 * kPointTolerance_mm) return true;
        if (dot(end_tangent(before), start_tangent(after)) < 0) return false;
        const Point between = point_at(after, share_at(after, location) / 2);
        return distance_mm(before, between) <= tolerance_mm_;
    }

    std::span<const Contour> contours_;
    double tolerance_mm_;
    std::span<const std::size_t> groups_;  // of the contours; empty: all are compared
    std::vector<EdgeId> edge_ids_;
    std::vector<Box> boxes_;
    BoxTree tree_;
};

}  // namespace

std::optional<Crossing> find_crossing(std::span<const Contour> contours, double tolerance_mm) {
    return CrossingSearch(contours, tolerance_mm, {}).run();
}

std::optional<Crossing> find_crossing_between(std::span<const Contour> contours,
                                              std::span<const std::size_t> groups) {
    return CrossingSearch(contours, 0, groups).run();
}

}  // namespace gsim::geometry
