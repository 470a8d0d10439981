#include "cam/drawing/fit_spline.h"

#include <cmath>

namespace gsim::drawing {

using geometry::Point;

namespace {

/// One equation for the derivatives at a point and its neighbours.
struct Stencil {
    double before = 0, current = 0, after = 0;
    Point right;
};

// Solves equations that contain only direct neighbours (Thomas).
std::vector<Point> solve(std::vector<Stencil> rows) {
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double share = rows[i].before / rows[i - 1].current;
        rows[i].current -= share * rows[i - 1].after;
        rows[i].right = rows[i].right - share * rows[i - 1].right;
    }
    std::vector<Point> values(rows.size());
    for (std::size_t i = rows.size(); i-- > 0;) {
        const Point remainder =
            i + 1 < rows.size() ? rows[i].right - rows[i].after * values[i + 1] : rows[i].right;
        values[i] = (1 / rows[i].current) * remainder;
    }
    return values;
}

// Solves equations whose first one also contains the last value, and the last one the first (Sherman and
// Morrison).
std::vector<Point> solve_cyclic(std::vector<Stencil> rows) {
    const double corner = rows.front().before;
    const double other = rows.back().after;
    const double shift = -rows.front().current;
    rows.front().current -= shift;
    rows.back().current -= corner * other / shift;
    std::vector<Stencil> unit = rows;
    for (Stencil& row : unit) row.right = {};
    unit.front().right.x = shift;
    unit.back().right.x = other;
    const std::vector<Point> correction = solve(std::move(unit));
    std::vector<Point> values = solve(std::move(rows));
    const double weight_sum = 1 + correction.front().x + corner * correction.back().x / shift;
    const Point share = (1 / weight_sum) * (values.front() + (corner / shift) * values.back());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = values[i] - correction[i].x * share;
    return values;
}

// The derivatives at the points by chord length; the curvature is continuous.
class Derivatives {
  public:
    explicit Derivatives(const std::vector<Point>& points) : points_(points) {}

    std::vector<Point> open(const SplineEnds& ends) const {
        const std::size_t last = points_.size() - 1;
        std::vector<Stencil> rows(points_.size());
        for (std::size_t i = 1; i < last; ++i) rows[i] = smooth(i - 1, i, i + 1);
        rows.front() =
            ends.start_direction ? clamped_row(*ends.start_direction) : Stencil{0, 2, 1, 3.0 * slope(0, 1)};
        rows.back() = ends.end_direction ? clamped_row(*ends.end_direction)
                                         : Stencil{1, 2, 0, 3.0 * slope(last - 1, last)};
        return solve(std::move(rows));
    }

    // Returns the derivatives of a closed curve, without the last point, which equals the first one.
    std::vector<Point> closed() const {
        const std::size_t count = points_.size();
        std::vector<Stencil> rows;
        rows.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            rows.push_back(smooth((i + count - 1) % count, i, (i + 1) % count));
        }
        return solve_cyclic(std::move(rows));
    }

  private:
    double chord(std::size_t from, std::size_t to) const { return distance(points_[from], points_[to]); }
    Point slope(std::size_t from, std::size_t to) const {
        return (1 / chord(from, to)) * (points_[to] - points_[from]);
    }
    static Stencil clamped_row(Point along) { return {0, 1, 0, (1 / std::hypot(along.x, along.y)) * along}; }
    Stencil smooth(std::size_t before, std::size_t current, std::size_t after) const {
        const double left = chord(before, current);
        const double right = chord(current, after);
        return {right, 2 * (left + right), left,
                3.0 * (right * slope(before, current) + left * slope(current, after))};
    }

    const std::vector<Point>& points_;
};

}  // namespace

std::vector<Nurbs> interpolating_spline(const std::vector<Point>& points, const SplineEnds& ends) {
    std::vector<Point> distinct_points;
    distinct_points.reserve(points.size());
    for (const Point& point : points) {
        if (distinct_points.empty() || distance(distinct_points.back(), point) > geometry::kPointTolerance_mm)
            distinct_points.push_back(point);
    }
    bool closed = ends.closed;
    while (closed && distinct_points.size() > 1 &&
           distance(distinct_points.front(), distinct_points.back()) <= geometry::kPointTolerance_mm) {
        distinct_points.pop_back();
    }
    if (distinct_points.size() < 2) return {};
    closed = closed && distinct_points.size() > 2;
    const Derivatives derivatives(distinct_points);
    const std::vector<Point> along = closed ? derivatives.closed() : derivatives.open(ends);
    std::vector<Nurbs> splines;
    const std::size_t count = distinct_points.size();
    for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
        const std::size_t next = (i + 1) % count;
        const double third = distance(distinct_points[i], distinct_points[next]) / 3;
        splines.push_back(bezier(distinct_points[i], distinct_points[i] + third * along[i],
                                 distinct_points[next] - third * along[next], distinct_points[next]));
    }
    return splines;
}

}  // namespace gsim::drawing
