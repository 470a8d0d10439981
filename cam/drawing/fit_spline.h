#pragma once

#include <optional>
#include <vector>

#include "cam/drawing/nurbs.h"

namespace gsim::drawing {

/// What a curve through points does at its ends. Without directions it is straight there (natural).
struct FitEnds {
    bool closed = false;                          ///< The last point leads on to the first one, smoothly.
    std::optional<geometry::Point> start_along;   ///< Direction of travel, of any length.
    std::optional<geometry::Point> finish_along;  ///< The same at the last point.
};

/// The cubic spline through points, as a cubic of Bezier between each two: continuous in position, tangent
/// and curvature, its parameter the length of the chords (de Boor, "A Practical Guide to Splines", 1978, ch.
/// IV; Piegl and Tiller, "The NURBS Book", 1997, 9.2). Points that lie on each other count once. Nothing
/// where fewer than two are left.
std::vector<Nurbs> spline_through(const std::vector<geometry::Point>& points, const FitEnds& ends);

}  // namespace gsim::drawing
