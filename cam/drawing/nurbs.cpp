#include "cam/drawing/nurbs.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace gsim::drawing {

using geometry::CurvePoint;
using geometry::Point;

namespace {

constexpr std::size_t kMaxDegree = 15;

// A point multiplied by its weight, and the weight.
struct HomogeneousPoint {
    Point point;
    double weight = 0;
};

HomogeneousPoint between(const HomogeneousPoint& a, const HomogeneousPoint& b, double share) {
    return {(1 - share) * a.point + share * b.point, (1 - share) * a.weight + share * b.weight};
}

}  // namespace

std::optional<Error> find_curve_error(const Nurbs& curve) {
    if (curve.degree < 1 || curve.degree > kMaxDegree) {
        return fmt::format("has degree {}; supported are 1 to {}", curve.degree, kMaxDegree);
    }
    if (curve.points.size() <= curve.degree) {
        return fmt::format("has {} control points; degree {} requires at least {}", curve.points.size(),
                           curve.degree, curve.degree + 1);
    }
    const std::size_t knots = curve.points.size() + curve.degree + 1;
    if (curve.knots.size() != knots) {
        return fmt::format("has {} knots; {} control points of degree {} require {}", curve.knots.size(),
                           curve.points.size(), curve.degree, knots);
    }
    if (!std::is_sorted(curve.knots.begin(), curve.knots.end())) return "has decreasing knots";
    if (!(curve.knots[curve.degree] < curve.knots[curve.points.size()])) return "has knots without a range";
    if (!curve.weights.empty() && curve.weights.size() != curve.points.size()) {
        return fmt::format("has {} weights for {} control points", curve.weights.size(), curve.points.size());
    }
    const auto is_valid_weight = [](double weight) { return weight > 0 && std::isfinite(weight); };
    if (!std::all_of(curve.weights.begin(), curve.weights.end(), is_valid_weight)) {
        return "has a weight that is not greater than 0";
    }
    return {};
}

CurvePoint curve_point(const Nurbs& curve, std::size_t span, double parameter) {
    const std::size_t degree = curve.degree;
    std::array<HomogeneousPoint, kMaxDegree + 1> d;
    for (std::size_t i = 0; i <= degree; ++i) {
        const std::size_t index = span - degree + i;
        const double weight = curve.weights.empty() ? 1 : curve.weights[index];
        d[i] = {weight * curve.points[index], weight};
    }
    HomogeneousPoint slope;
    for (std::size_t level = 1; level <= degree; ++level) {
        if (level == degree) {
            slope = {d[degree].point - d[degree - 1].point, d[degree].weight - d[degree - 1].weight};
        }
        for (std::size_t i = degree; i >= level; --i) {
            const double low = curve.knots[span - degree + i];
            const double high = curve.knots[span + 1 + i - level];
            d[i] = between(d[i - 1], d[i], (parameter - low) / (high - low));
        }
    }
    const HomogeneousPoint& at = d[degree];
    const Point position = (1 / at.weight) * at.point;
    return {position, slope.point - slope.weight * position};
}

Nurbs bezier(Point a, Point b, Point c, Point d) {
    return {3, {0, 0, 0, 0, 1, 1, 1, 1}, {a, b, c, d}, {}};
}

}  // namespace gsim::drawing
