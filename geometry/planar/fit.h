#pragma once

#include <functional>

#include "geometry/planar/contour.h"

namespace gsim::geometry {

/// A point of a curve and the direction of travel there, of any length; where the parameter falls, that of
/// the falling parameter.
struct CurvePoint {
    Point position, direction;
};

using Curve = std::function<CurvePoint(double parameter)>;

/// Appends arcs that run along a smooth stretch of a curve: pairs of arcs with the curve's tangents at their
/// ends (biarcs; Bolton, "Biarc curves", Computer-Aided Design 7, 1975), halved until points between are
/// within `tolerance_mm`. Ends are met exactly.
void fit_arcs(const Curve& curve, double from, double to, double tolerance_mm, std::uint32_t source,
              Contour& contour);

}  // namespace gsim::geometry
