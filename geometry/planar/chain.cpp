#include "geometry/planar/chain.h"

#include <limits>
#include <optional>

#include "geometry/planar/box_tree.h"

namespace gsim::geometry {

namespace {

constexpr std::size_t kMaxEnds = 64;  // at one position
constexpr double kExactTolerance_mm = 1e-6;

// The ends of open parts: end 2i is the first vertex of part i, end 2i + 1 its last one.
class EndpointIndex {
  public:
    EndpointIndex(const std::vector<Contour>& drawn_contours, double tolerance_mm)
        : tolerance_mm_(tolerance_mm), used_(drawn_contours.size(), false) {
        points_.reserve(2 * drawn_contours.size());
        for (const Contour& drawn_contour : drawn_contours) {
            points_.push_back(drawn_contour.vertices.front().position);
            points_.push_back(drawn_contour.vertices.back().position);
        }
        std::vector<Box> boxes;
        boxes.reserve(points_.size());
        for (const Point& point : points_) boxes.push_back({point, point});
        tree_ = BoxTree(boxes);
    }

    bool used(std::size_t drawn_contour) const { return used_[drawn_contour]; }
    void mark_used(std::size_t drawn_contour) { used_[drawn_contour] = true; }
    bool is_ambiguous() const { return is_ambiguous_; }
    double tolerance_mm() const { return tolerance_mm_; }

    // Returns the nearest end of a part that is not used.
    std::optional<std::size_t> nearest(Point point) {
        std::optional<std::size_t> best;
        double best_mm = tolerance_mm_;
        std::size_t seen = 0;
        tree_.visit(Box{point, point}.expanded(tolerance_mm_), [&](std::size_t end) {
            const double gap = distance(points_[end], point);
            if (!used_[end / 2] && gap <= best_mm) {
                best = end;
                best_mm = gap;
            }
            is_ambiguous_ = is_ambiguous_ || ++seen > kMaxEnds;
            return !is_ambiguous_;
        });
        return best;
    }
    Point point(std::size_t end) const { return points_[end]; }

  private:
    double tolerance_mm_;
    std::vector<Point> points_;
    std::vector<bool> used_;
    BoxTree tree_;
    bool is_ambiguous_ = false;
};

void append(Contour& chain, Contour drawn_contour, bool from_end) {
    if (from_end) reverse(drawn_contour);
    chain.vertices.back().bulge = drawn_contour.vertices.front().bulge;
    chain.vertices.back().source = drawn_contour.vertices.front().source;
    chain.vertices.insert(chain.vertices.end(), drawn_contour.vertices.begin() + 1,
                          drawn_contour.vertices.end());
}

// Extends the chain from its end as far as parts are available. True if it came back to its own start.
bool grow(Contour& chain, std::vector<Contour>& drawn_contours, EndpointIndex& ends) {
    for (;;) {
        const Point current = chain.vertices.back().position;
        const double distance_to_start = distance(current, chain.vertices.front().position);
        const std::optional<std::size_t> end = ends.nearest(current);
        const bool can_close = chain.vertices.size() > 2 && distance_to_start <= ends.tolerance_mm();
        if (can_close && (!end || distance_to_start <= distance(current, ends.point(*end)))) {
            chain.vertices.pop_back();
            chain.closed = true;
            return true;
        }
        if (!end) return false;
        ends.mark_used(*end / 2);
        append(chain, std::move(drawn_contours[*end / 2]), *end % 2 == 1);
    }
}

void chain_within(std::vector<Contour> drawn_contours, double tolerance_mm, ChainResult& result) {
    EndpointIndex ends(drawn_contours, tolerance_mm);
    for (std::size_t i = 0; i < drawn_contours.size(); ++i) {
        if (ends.used(i)) continue;
        ends.mark_used(i);
        Contour chain = std::move(drawn_contours[i]);
        bool closed = grow(chain, drawn_contours, ends);
        if (!closed) {
            reverse(chain);
            closed = grow(chain, drawn_contours, ends);
        }
        (closed ? result.closed : result.open).push_back(std::move(chain));
    }
    result.is_ambiguous = result.is_ambiguous || ends.is_ambiguous();
}

}  // namespace

ChainResult chain(std::vector<Contour> drawn_contours, double tolerance_mm) {
    ChainResult result;
    std::vector<Contour> open;
    for (Contour& drawn_contour : drawn_contours) {
        if (drawn_contour.vertices.size() < 2) continue;
        (drawn_contour.closed ? result.closed : open).push_back(std::move(drawn_contour));
    }
    for (const double within : {std::min(kExactTolerance_mm, tolerance_mm), tolerance_mm}) {
        result.open.clear();
        chain_within(std::move(open), within, result);
        open = result.open;
    }
    for (Contour& contour : result.closed) remove_short_edges(contour);
    return result;
}

void remove_short_edges(Contour& contour) {
    std::vector<Vertex> kept;
    kept.reserve(contour.vertices.size());
    for (std::size_t i = 0; i < contour.vertices.size(); ++i) {
        const bool last = !contour.closed && i + 1 == contour.vertices.size();
        const Edge edge = contour.edge(i);
        if (last || distance(edge.start, edge.end) > kPointTolerance_mm) kept.push_back(contour.vertices[i]);
    }
    contour.vertices = std::move(kept);
}

}  // namespace gsim::geometry
