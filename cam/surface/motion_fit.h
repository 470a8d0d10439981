#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cam/surface/jet_point.h"

namespace gsim::surface {

/// A line or an arc of the TCP, on which the axis turns in proportion about the vertical and away from it.
struct JetMove {
    Vector end_mm;
    std::optional<Vector> via_mm;  ///< Midpoint of an arc.
    double radius_mm = 0;          ///< Radius of an arc.
    Vector axis;                   ///< At its end.
    double edge_mm = 0;            ///< Length along the contour.
    double tcp_mm = 0;             ///< Path length of the TCP.
    double depth_mm = 0;           ///< Max depth that the jet cuts.
    double corner_rad = 0;         ///< Turn of a near corner, see JetPoint.
    bool axis_changes = false;     ///< The axis at its end is another one than at its begin.
};

/// Max deviation of moves from the points that they replace.
struct FitTolerance {
    double tcp_mm = 0.005;   ///< At the TCP.
    double wall_mm = 0.015;  ///< At the lower end of the wall, by the axis.
};

/// Returns as few moves as possible through points, starting at the first one.
std::vector<JetMove> fit_moves(std::span<const JetPoint> points, const JetShape& jet,
                               const FitTolerance& tolerance);

}  // namespace gsim::surface
