#pragma once

#include <optional>
#include <vector>

#include "cam/drawing/nurbs.h"

namespace gsim::drawing {

/// End conditions of a curve through points. Without directions it is straight there (natural).
struct SplineEnds {
    bool closed = false;                             ///< The last point leads on to the first one, smoothly.
    std::optional<geometry::Point> start_direction;  ///< Direction of travel, of any length.
    std::optional<geometry::Point> end_direction;    ///< The same at the last point.
};

/// Returns the cubic spline through points, as a cubic Bezier curve between each two: continuous in position,
/// tangent and curvature, with the chord length as its parameter (de Boor, "A Practical Guide to Splines",
/// 1978, ch. IV; Piegl and Tiller, "The NURBS Book", 1997, 9.2). Coincident points count once. Returns
/// nothing if fewer than two points remain.
std::vector<Nurbs> interpolating_spline(const std::vector<geometry::Point>& points, const SplineEnds& ends);

}  // namespace gsim::drawing
