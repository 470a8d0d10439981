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

/// Values of the machine's axes in their order, as the axes read: mm or deg.
using AxisVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, rrs::kMaxJoints, 1>;

/// How fast a feed move goes: a speed, or a time for the whole move (inverse time feed).
struct Feed {
    double linear_mm_min = 0;   ///< Of the tool, where a linear axis moves.
    double rotary_deg_min = 0;  ///< Where rotary axes alone move.
    std::optional<double> motion_s = {};
    /// Where the program gives the feed, or the lead of a thread, by turns of the spindle: what it is there;
    /// linear_mm_min is that at the speed of the spindle.
    std::optional<double> linear_mm_rev = {};
};

/// How the ends of moves are passed.
struct PathPassing {
    rrs::PathMode mode = rrs::PathMode::exact_stop;
    double tolerance_mm = 0;        ///< Of the path; 0: as the controller does.
    double merge_tolerance_mm = 0;  ///< Of lines that are merged.

    bool operator==(const PathPassing&) const = default;
};

/// A work coordinate system that a program selects.
struct WorkOffset {
    std::string name;               ///< As programs call it, without the G: "54", "59.1".
    std::map<char, double> origin;  ///< By axis letter, mm or deg, as the machine's data had it at the start.
    double rotation_deg = 0;        ///< About Z, likewise.
    bool moved = false;             ///< The program itself has put it elsewhere since.
};

/// One move of the program in machine coordinates.
struct LineMove {
    MoveKind kind = MoveKind::linear;  ///< Any but an arc or a dwell.
    AxisVector target;
    Feed feed;
    Place place;
};

/// An arc in any plane, or a helix about the plane's normal.
struct ArcMove {
    MoveKind kind = MoveKind::arc_cw;                     ///< As seen against the normal.
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();    ///< Unit, told_normal(), of X, Y and Z.
    Eigen::Vector3d center_mm = Eigen::Vector3d::Zero();  ///< Any point of the arc's axis.
    double sweep_rad = 0;                                 ///< > 0
    AxisVector target;
    Feed feed;
    Place place;

    /// The unit vector about which the arc runs by the right hand.
    Eigen::Vector3d axis() const;
    /// From the axis to a point, at right angles to it.
    Eigen::Vector3d radius_to(const Eigen::Vector3d& point_mm) const;
    /// The length of the way between two points (of X, Y and Z), as long as its radius is that of the first.
    double length_mm(const Eigen::Vector3d& start_mm, const Eigen::Vector3d& end_mm) const;
};

/// An arc through a point, in any plane of space.
struct ViaMove {
    AxisVector via;
    AxisVector target;
    Feed feed;
    Place place;
};

/// Where an axis of a group goes beside a move to a pose.
struct GroupTarget {
    std::size_t axis = 0;
    double value = 0;  ///< mm or deg
};

/// A line of the tool's centre point in the work frame, or with a point on the way an arc; the tool turns
/// evenly to the orientation of `target`. Axes of groups that have no target stay where they are.
struct PoseMove {
    std::optional<rrs::CartPos> via;
    rrs::CartPos target;
    std::vector<GroupTarget> groups;
    Feed feed;
    Place place;
};

}  // namespace gsim::simulation
