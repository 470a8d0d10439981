#include "cam/drawing/fit_spline.h"

#include <cmath>

namespace gsim::drawing {

using geometry::Point;

namespace {

/// One equation for the derivatives at a point and its neighbours.
struct Row {
    double before = 0, here = 0, behind = 0;
    Point right;
};

// Solves equations that contain only direct neighbours (Thomas).
std::vector<Point> solve(std::vector<Row> rows) {
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double share = rows[i].before / rows[i - 1].here;
        rows[i].here -= share * rows[i - 1].behind;
        rows[i].right = rows[i].right - share * rows[i - 1].right;
    }
    std::vector<Point> values(rows.size());
    for (std::size_t i = rows.size(); i-- > 0;) {
        const Point rest =
            i + 1 < rows.size() ? rows[i].right - rows[i].behind * values[i + 1] : rows[i].right;
        values[i] = (1 / rows[i].here) * rest;
    }
    return values;
}

// Solves equations whose first one also contains the last value, and the last one the first (Sherman and
// Morrison).
std::vector<Point> solve_ring(std::vector<Row> rows) {
    const double corner = rows.front().before;
    const double other = rows.back().behind;
    const double shift = -rows.front().here;
    rows.front().here -= shift;
    rows.back().here -= corner * other / shift;
    std::vector<Row> unit = rows;
    for (Row& row : unit) row.right = {};
    unit.front().right.x = shift;
    unit.back().right.x = other;
    const std::vector<Point> bent = solve(std::move(unit));
    std::vector<Point> values = solve(std::move(rows));
    const double whole = 1 + bent.front().x + corner * bent.back().x / shift;
    const Point share = (1 / whole) * (values.front() + (corner / shift) * values.back());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = values[i] - bent[i].x * share;
    return values;
}

// The derivatives at the points by chord length; the curvature is continuous.
class Derivatives {
  public:
    explicit Derivatives(const std::vector<Point>& points) : points_(points) {}

    std::vector<Point> open(const FitEnds& ends) const {
        const std::size_t last = points_.size() - 1;
        std::vector<Row> rows(points_.size());
        for (std::size_t i = 1; i < last; ++i) rows[i] = smooth(i - 1, i, i + 1);
        rows.front() = ends.start_along ? fixed(*ends.start_along) : Row{0, 2, 1, 3.0 * slope(0, 1)};
        rows.back() =
            ends.finish_along ? fixed(*ends.finish_along) : Row{1, 2, 0, 3.0 * slope(last - 1, last)};
        return solve(std::move(rows));
    }

    // Returns the derivatives of a closed curve, without the last point, which equals the first one.
    std::vector<Point> closed() const {
        const std::size_t count = points_.size();
        std::vector<Row> rows;
        rows.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            rows.push_back(smooth((i + count - 1) % count, i, (i + 1) % count));
        }
        return solve_ring(std::move(rows));
    }

  private:
    double chord(std::size_t from, std::size_t to) const { return distance(points_[from], points_[to]); }
    Point slope(std::size_t from, std::size_t to) const {
        return (1 / chord(from, to)) * (points_[to] - points_[from]);
    }
    static Row fixed(Point along) { return {0, 1, 0, (1 / std::hypot(along.x, along.y)) * along}; }
    Row smooth(std::size_t before, std::size_t here, std::size_t behind) const {
        const double left = chord(before, here);
        const double right = chord(here, behind);
        return {right, 2 * (left + right), left,
                3.0 * (right * slope(before, here) + left * slope(here, behind))};
    }

    const std::vector<Point>& points_;
};

}  // namespace

std::vector<Nurbs> spline_through(const std::vector<Point>& points, const FitEnds& ends) {
    std::vector<Point> apart;
    apart.reserve(points.size());
    for (const Point& point : points) {
        if (apart.empty() || distance(apart.back(), point) > geometry::kSamePoint_mm) apart.push_back(point);
    }
    bool closed = ends.closed;
    while (closed && apart.size() > 1 && distance(apart.front(), apart.back()) <= geometry::kSamePoint_mm) {
        apart.pop_back();
    }
    if (apart.size() < 2) return {};
    closed = closed && apart.size() > 2;
    const Derivatives derivatives(apart);
    const std::vector<Point> along = closed ? derivatives.closed() : derivatives.open(ends);
    std::vector<Nurbs> pieces;
    const std::size_t count = apart.size();
    for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
        const std::size_t next = (i + 1) % count;
        const double third = distance(apart[i], apart[next]) / 3;
        pieces.push_back(
            bezier(apart[i], apart[i] + third * along[i], apart[next] - third * along[next], apart[next]));
    }
    return pieces;
}

}  // namespace gsim::drawing
