#include "geometry/planar/chain.h"

#include <limits>
#include <optional>

#include "geometry/planar/box_tree.h"

namespace gsim::geometry {

namespace {

constexpr std::size_t kMaxEnds = 64;  // at one position
constexpr double kExact_mm = 1e-6;

// The ends of open parts: end 2i is the first vertex of part i, end 2i + 1 its last one.
class Ends {
  public:
    Ends(const std::vector<Contour>& pieces, double tolerance_mm)
        : tolerance_mm_(tolerance_mm), used_(pieces.size(), false) {
        points_.reserve(2 * pieces.size());
        for (const Contour& piece : pieces) {
            points_.push_back(piece.vertices.front().position);
            points_.push_back(piece.vertices.back().position);
        }
        std::vector<Box> boxes;
        boxes.reserve(points_.size());
        for (const Point& point : points_) boxes.push_back({point, point});
        tree_ = BoxTree(boxes);
    }

    bool used(std::size_t piece) const { return used_[piece]; }
    void use(std::size_t piece) { used_[piece] = true; }
    bool crowded() const { return crowded_; }
    double tolerance_mm() const { return tolerance_mm_; }

    // Returns the nearest end of a part that is not used.
    std::optional<std::size_t> nearest(Point point) {
        std::optional<std::size_t> best;
        double best_mm = tolerance_mm_;
        std::size_t seen = 0;
        tree_.visit(Box{point, point}.grown(tolerance_mm_), [&](std::size_t end) {
            const double apart = distance(points_[end], point);
            if (!used_[end / 2] && apart <= best_mm) {
                best = end;
                best_mm = apart;
            }
            crowded_ = crowded_ || ++seen > kMaxEnds;
            return !crowded_;
        });
        return best;
    }
    Point point(std::size_t end) const { return points_[end]; }

  private:
    double tolerance_mm_;
    std::vector<Point> points_;
    std::vector<bool> used_;
    BoxTree tree_;
    bool crowded_ = false;
};

void append(Contour& chain, Contour piece, bool from_its_end) {
    if (from_its_end) reverse(piece);
    chain.vertices.back().bulge = piece.vertices.front().bulge;
    chain.vertices.back().source = piece.vertices.front().source;
    chain.vertices.insert(chain.vertices.end(), piece.vertices.begin() + 1, piece.vertices.end());
}

// Extends the chain from its end as far as parts are available. True if it came back to its own start.
bool grow(Contour& chain, std::vector<Contour>& pieces, Ends& ends) {
    for (;;) {
        const Point here = chain.vertices.back().position;
        const double to_start = distance(here, chain.vertices.front().position);
        const std::optional<std::size_t> end = ends.nearest(here);
        const bool may_close = chain.vertices.size() > 2 && to_start <= ends.tolerance_mm();
        if (may_close && (!end || to_start <= distance(here, ends.point(*end)))) {
            chain.vertices.pop_back();
            chain.closed = true;
            return true;
        }
        if (!end) return false;
        ends.use(*end / 2);
        append(chain, std::move(pieces[*end / 2]), *end % 2 == 1);
    }
}

void chain_within(std::vector<Contour> pieces, double tolerance_mm, Chained& result) {
    Ends ends(pieces, tolerance_mm);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (ends.used(i)) continue;
        ends.use(i);
        Contour chain = std::move(pieces[i]);
        bool closed = grow(chain, pieces, ends);
        if (!closed) {
            reverse(chain);
            closed = grow(chain, pieces, ends);
        }
        (closed ? result.closed : result.open).push_back(std::move(chain));
    }
    result.crowded = result.crowded || ends.crowded();
}

}  // namespace

Chained chain(std::vector<Contour> pieces, double tolerance_mm) {
    Chained result;
    std::vector<Contour> open;
    for (Contour& piece : pieces) {
        if (piece.vertices.size() < 2) continue;
        (piece.closed ? result.closed : open).push_back(std::move(piece));
    }
    for (const double within : {std::min(kExact_mm, tolerance_mm), tolerance_mm}) {
        result.open.clear();
        chain_within(std::move(open), within, result);
        open = result.open;
    }
    for (Contour& contour : result.closed) drop_short_edges(contour);
    return result;
}

void drop_short_edges(Contour& contour) {
    std::vector<Vertex> kept;
    kept.reserve(contour.vertices.size());
    for (std::size_t i = 0; i < contour.vertices.size(); ++i) {
        const bool last = !contour.closed && i + 1 == contour.vertices.size();
        const Edge edge = contour.edge(i);
        if (last || distance(edge.start, edge.end) > kSamePoint_mm) kept.push_back(contour.vertices[i]);
    }
    contour.vertices = std::move(kept);
}

}  // namespace gsim::geometry
