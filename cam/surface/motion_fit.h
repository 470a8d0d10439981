#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// A line or an arc of the tip, on which the axis turns in proportion about the vertical and from it.
struct JetMove {
    Vector end_mm;
    std::optional<Vector> via_mm;  ///< Of an arc: half way.
    double radius_mm = 0;          ///< Of an arc.
    Vector axis;                   ///< At its end.
    double edge_mm = 0;            ///< How far it goes along the contour.
    double tip_mm = 0;             ///< How far the tip goes.
    double depth_mm = 0;           ///< The most that the jet goes through.
    double corner_rad = 0;         ///< Of a corner that it is near to, see JetPoint.
    bool turns = false;            ///< The axis at its end is another one than at its begin.
};

/// How far moves may be off the points that they stand for.
struct FitTolerance {
    double tip_mm = 0.005;   ///< Of the tip.
    double wall_mm = 0.015;  ///< At the lower end of the wall, by the axis.
};

/// As few moves as go through points, begun at the first one.
std::vector<JetMove> fit_moves(std::span<const JetPoint> points, const JetShape& jet,
                               const FitTolerance& tolerance);

}  // namespace gsim::surface
