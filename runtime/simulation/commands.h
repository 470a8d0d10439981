#pragma once

#include <Eigen/Core>
#include <optional>

#include "runtime/rrs/types.h"
#include "runtime/simulation/move.h"

namespace gsim::simulation {

/// Values of the machine's axes in their order, as the axes read: mm or deg.
using AxisVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, rrs::kMaxJoints, 1>;

/// How fast a feed move goes: a speed, or a time for the whole move (inverse time feed).
struct Feed {
    double linear_mm_min = 0;   ///< Of the tool, where a linear axis moves.
    double rotary_deg_min = 0;  ///< Where rotary axes alone move.
    std::optional<double> motion_s;
};

/// One move of the program in machine coordinates.
struct LineMove {
    MoveKind kind = MoveKind::linear;  ///< Any but an arc or a dwell.
    AxisVector target;
    Feed feed;
    Place place;
};

/// An arc in one of the main planes, or a helix about the plane's normal.
struct ArcMove {
    MoveKind kind = MoveKind::arc_cw;
    Plane plane = Plane::xy;
    double center_first_mm = 0;   ///< On the plane's first axis (x, z, y of xy, zx, yz).
    double center_second_mm = 0;  ///< On its second axis (y, x, z).
    double sweep_rad = 0;         ///< > 0
    AxisVector target;
    Feed feed;
    Place place;
};

/// An arc through a point, in any plane of space.
struct ViaMove {
    AxisVector via;
    AxisVector target;
    Feed feed;
    Place place;
};

/// A line of the tool's centre point in the work frame, or with a point on the way an arc; the tool turns
/// evenly to the orientation of `target`.
struct PoseMove {
    std::optional<rrs::CartPos> via;
    rrs::CartPos target;
    Feed feed;
    Place place;
};

}  // namespace gsim::simulation
