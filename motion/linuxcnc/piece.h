#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "controller/services/types.h"
#include "motion/linuxcnc/planning.h"
#include "motion/path/arc.h"
#include "motion/planner/override_schedule.h"
#include "motion/segment/segment.h"

namespace gsim::motion::linuxcnc {

/// Share of the acceleration that an arc has along its way unless it is known to need less of it across.
inline constexpr double kTangentialShare = 0.5;
/// Share of the acceleration that an arc may take across its way.
inline constexpr double kNormalShare = 0.86602540378443864676;
/// Speeds are such that a piece takes this many periods at least, where it is passed without a stop.
inline constexpr double kLeastPeriods = 1.02;

/// How a piece ends.
enum class Term : std::uint8_t {
    stop,      ///< At rest (G61.1).
    exact,     ///< At rest unless the path goes on straight (G61).
    parabola,  ///< While it comes to rest the next one starts (G64).
    tangent,   ///< At the speed at which the next one starts.
};

/// A line or an arc with what limits the speed along it, in mm or, where only rotary joints move, in rad.
struct Piece {
    rrs::TargetId target_id = 0;
    bool curved = false;  ///< Along `arc`; else straight from start to end in all joints.
    bool rapid = false;
    ObeyedOverrides obeyed;
    bool follows_spindle = false;
    bool turns = false;        ///< Moves joints other than X, Y and Z.
    bool path_limited = true;  ///< max_path_speed counts: not where rotary joints alone move.
    rrs::JointPos start;
    rrs::JointPos end;
    Arc arc;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< Of a line in X, Y, Z; 0 where these rest.

    double length = 0;
    double nominal_length = 0;  ///< Before anything was cut off for blend arcs.
    double requested_speed = 0;
    double max_speed = 0;
    double max_path_speed = 0;
    double full_acceleration = 0;
    double tangential_share = kTangentialShare;  ///< Of an arc.
    double jerk = kUnlimited;                    ///< Of its ramps.
    double path_jerk = kUnlimited;               ///< That of any path; across arcs, too.
    double tolerance_mm = 0;                     ///< How far its corners may be cut; 0: as far as it comes.

    Term term = Term::stop;
    bool after_parabola = false;  ///< Starts while the one before comes to rest.
    bool after_tangent = false;   ///< Starts at the speed of the one before.
    bool settled = false;         ///< What follows is known: lengths and limits are final.
    double kink_speed = -1;       ///< At the end, where it limits the speed there; -1: it does not.
    double kink_at_start = 0;     ///< Shares of the acceleration that are kept for the kinks at its ends.
    double kink_at_end = 0;

    double lead_in = 0;  ///< Length of the straight line on which a blend arc begins.
    rrs::TargetId lead_in_id = 0;
    double deviation_mm = 0;  ///< Of a blend arc: how far it passes from the corner.
    OffWay off_way = OffWay::no;

    LimitedBy speed_limit;
    LimitedBy acceleration_limit;
};

/// The acceleration that a piece has for its speed along and its curvature across the way.
double whole_acceleration(const Piece& piece);
/// The acceleration along the way, for which speeds are planned.
double acceleration(const Piece& piece);
/// The acceleration along the way while the piece moves alone.
double acceleration_alone(const Piece& piece, const Planning& planning);
/// The speed that it goes at where nothing else slows it, with `share` of the speed that it asks for.
double target_speed(const Piece& piece, double share = 1);

/// Unit tangents in X, Y, Z; 0 where these rest.
Eigen::Vector3d start_direction(const Piece& piece);
Eigen::Vector3d end_direction(const Piece& piece);

/// The length by which an arc is travelled.
double way_length(const Arc& arc);
/// The radius of a circle that takes as much acceleration across as the arc does.
double effective_radius_mm(const Arc& arc);

/// Lowers the speed of an arc to what its acceleration across allows, and tells its acceleration along.
void limit_on_arc(Piece& piece, const Planning& planning);

/// Makes the limits final, when the piece that follows is known. Not done for the last one before a stop of
/// the queue.
void settle(Piece& piece, const Planning& planning);

}  // namespace gsim::motion::linuxcnc
