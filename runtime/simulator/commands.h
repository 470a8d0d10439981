#pragma once

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "controller/services/types.h"
#include "runtime/simulator/move.h"

namespace gsim::simulation {

/// Values of the machine's axes in their order, as displayed: mm or deg.
using AxisVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, rrs::kMaxJoints, 1>;

/// Speed of a feed move: a speed, or a time for the full move (inverse time feed).
struct Feed {
    double linear_mm_min = 0;   ///< For the tool, if a linear axis moves.
    double rotary_deg_min = 0;  ///< If only rotary axes move.
    std::optional<double> motion_s = {};
    /// Feed or lead of a thread per turn of the spindle, if the program gives it so; linear_mm_min is the
    /// feed at the speed of the spindle.
    std::optional<double> linear_mm_rev = {};
};

/// Behaviour of the path at the ends of moves.
struct PathModeSettings {
    rrs::PathMode mode = rrs::PathMode::exact_stop;
    double tolerance_mm = 0;        ///< Path tolerance; 0: controller's default.
    double merge_tolerance_mm = 0;  ///< Tolerance of merged lines.

    bool operator==(const PathModeSettings&) const = default;
};

/// Work coordinate system that a program selects.
struct WorkOffset {
    std::string name;               ///< As programs call it, without the G: "54", "59.1".
    std::map<char, double> origin;  ///< By axis letter, mm or deg, as the machine's data had it at the start.
    double rotation_deg = 0;        ///< About Z, likewise.
    bool moved = false;             ///< The program itself has moved it since.
};

/// Move of the program in machine coordinates.
struct LineMove {
    MoveKind kind = MoveKind::linear;  ///< Any but an arc or a dwell.
    AxisVector target;
    Feed feed;
    SourceLocation location;
};

/// Arc in any plane, or a helix about the plane's normal.
struct ArcMove {
    MoveKind kind = MoveKind::arc_cw;                     ///< As seen against the normal.
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();    ///< Unit, canonical_normal(), of X, Y and Z.
    Eigen::Vector3d center_mm = Eigen::Vector3d::Zero();  ///< Any point of the arc's axis.
    double sweep_rad = 0;                                 ///< > 0
    AxisVector target;
    Feed feed;
    SourceLocation location;

    /// Returns the unit vector about which the arc runs by the right-hand rule.
    Eigen::Vector3d axis() const;
    /// Returns the vector from the axis to a point, at right angles to the axis.
    Eigen::Vector3d radius_to(const Eigen::Vector3d& point_mm) const;
    /// Returns the length of the path between two points (of X, Y and Z), if the radius stays that of the
    /// first.
    double length_mm(const Eigen::Vector3d& start_mm, const Eigen::Vector3d& end_mm) const;
};

/// Arc through a point, in any plane of space.
struct ViaMove {
    AxisVector via;
    AxisVector target;
    Feed feed;
    SourceLocation location;
};

/// Target of an axis of a group during a move to a pose.
struct GroupTarget {
    std::size_t axis = 0;
    double value = 0;  ///< mm or deg
};

/// Line of the TCP in the work frame, or an arc if a via point is given; the tool turns evenly to the
/// orientation of `target`. Axes of groups without a target do not move.
struct PoseMove {
    std::optional<rrs::CartPos> via;
    rrs::CartPos target;
    std::vector<GroupTarget> groups;
    Feed feed;
    SourceLocation location;
};

}  // namespace gsim::simulation
