#pragma once

#include <functional>

#include "geometry/planar/contour.h"

namespace gsim::geometry {

/// A point of a curve and the direction of travel there, of any length. If the parameter falls, the direction
/// is that of the falling parameter.
struct CurvePoint {
    Point position, direction;
};

using Curve = std::function<CurvePoint(double parameter)>;

/// Appends arcs along a smooth stretch of a curve. These are pairs of arcs with the curve's tangents at their
/// ends (biarcs; Bolton, "Biarc curves", Computer-Aided Design 7, 1975). They are halved until points between
/// are within `tolerance_mm`. Ends are met exactly.
void fit_arcs(const Curve& curve, double from, double to, double tolerance_mm, std::uint32_t source,
              Contour& contour);

}  // namespace gsim::geometry
