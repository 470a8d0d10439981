#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "geometry/planar/fit.h"

namespace gsim::drawing {

/// A rational B-spline curve.
struct Nurbs {
    std::size_t degree = 3;
    std::vector<double> knots;  ///< points.size() + degree + 1, never falling.
    std::vector<geometry::Point> points;
    std::vector<double> weights;  ///< One for each point, or empty.
};

/// Returns the error of a curve, as the end of a message that begins with its name.
std::optional<Error> find_curve_error(const Nurbs& curve);

/// Returns the point in the span of knots[span] to knots[span + 1] of a valid curve (de Boor's algorithm;
/// Piegl and Tiller, "The NURBS Book", 1997, ch. 4).
geometry::CurvePoint curve_point(const Nurbs& curve, std::size_t span, double parameter);

/// Returns a cubic Bezier curve.
Nurbs bezier(geometry::Point a, geometry::Point b, geometry::Point c, geometry::Point d);

}  // namespace gsim::drawing
