#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "controller/services/types.h"
#include "motion/linuxcnc/planning_rules.h"
#include "motion/path/arc.h"
#include "motion/planner/override_schedule.h"
#include "motion/segment/segment.h"

namespace gsim::motion::linuxcnc {

/// Share of the acceleration that an arc has along its path unless it is known to need less of it across.
inline constexpr double kTangentialShare = 0.5;
/// Share of the acceleration that an arc may use across its path.
inline constexpr double kNormalShare = 0.86602540378443864676;
/// Minimum number of periods that a sub-segment takes if it is passed without a stop.
inline constexpr double kMinPeriods = 1.02;

/// End condition of a sub-segment.
enum class EndCondition : std::uint8_t {
    stop,      ///< At standstill (G61.1).
    exact,     ///< At standstill unless the path continues straight (G61).
    parabola,  ///< The next one starts while it stops (G64).
    tangent,   ///< At the speed at which the next one starts.
};

/// Limits of the motion along a sub-segment, in mm or, if only rotary joints move, in rad.
struct SubSegmentLimits {
    double requested_speed = 0;
    double max_speed = 0;
    double max_path_speed = 0;
    bool path_limited = true;  ///< True if max_path_speed counts: not if only rotary joints move.
    double full_acceleration = 0;
    double tangential_share = kTangentialShare;  ///< Only for an arc.
    double jerk = kUnlimited;                    ///< Jerk of its ramps.
    double path_jerk = kUnlimited;               ///< That of any path; across arcs, too.
    LimitCause speed_limit;
    LimitCause acceleration_limit;
};

/// Passage from the sub-segment before and to the next one.
struct SubSegmentJunctions {
    EndCondition end_condition = EndCondition::stop;
    double tolerance_mm = 0;        ///< Tolerance for cutting its corners; 0: without limit.
    bool after_parabola = false;    ///< True if it starts while the one before stops.
    bool after_tangent = false;     ///< Starts at the speed of the one before.
    double corner_speed = -1;       ///< Corner speed at the end if it limits the speed there; -1: no limit.
    double start_corner_share = 0;  ///< Shares of the acceleration that are kept for the kinks at its ends.
    double end_corner_share = 0;
};

/// Straight line where a blend arc begins.
struct LeadIn {
    double length = 0;
    rrs::TargetId target_id = 0;
};

/// Line or arc with the limits of the speed along it, in mm or, if only rotary joints move, in rad.
struct SubSegment {
    rrs::TargetId target_id = 0;
    bool curved = false;  ///< Along `arc`; else straight from start to end in all joints.
    bool rapid = false;
    EnabledOverrides enabled_overrides;
    bool follows_spindle = false;
    bool turns = false;     ///< Moves joints other than X, Y and Z.
    bool is_final = false;  ///< True if the next one is known: lengths and limits are final.
    rrs::JointPos start;
    rrs::JointPos end;
    Arc arc;
    Eigen::Vector3d direction =
        Eigen::Vector3d::Zero();  ///< Line direction in X, Y, Z; 0 if these do not move.

    double length = 0;
    double nominal_length = 0;  ///< Before anything was cut off for blend arcs.
    SubSegmentLimits limits;
    SubSegmentJunctions junctions;
    LeadIn lead_in;
    double deviation_mm = 0;  ///< Distance of a blend arc from the corner.
    PathDeviation path_deviation = PathDeviation::no;
};

/// Returns the acceleration that a sub-segment has for both its speed along the path and its curvature across
/// it.
double total_acceleration(const SubSegment& sub_segment);
/// Returns the acceleration along the path for which speeds are planned.
double acceleration(const SubSegment& sub_segment);
/// Returns the acceleration along the path while the sub-segment moves alone.
double isolated_acceleration(const SubSegment& sub_segment, const PlanningRules& planning);
/// Returns the speed that no other limit slows, with `share` of the requested speed.
double target_speed(const SubSegment& sub_segment, double share = 1);

/// Returns the unit tangent in X, Y, Z; 0 if these do not move.
Eigen::Vector3d start_direction(const SubSegment& sub_segment);
Eigen::Vector3d end_direction(const SubSegment& sub_segment);

/// Returns the length by which an arc is travelled.
double timed_arc_length(const Arc& arc);
/// Returns the radius of a circle that takes as much normal acceleration as the arc does.
double effective_radius_mm(const Arc& arc);

/// Lowers the speed of an arc to what its normal acceleration allows, and sets its acceleration along the
/// path.
void limit_on_arc(SubSegment& sub_segment, const PlanningRules& planning);

/// Makes the limits final, once the next sub-segment is known. Not called for the last one before a stop of
/// the queue.
void finalize(SubSegment& sub_segment, const PlanningRules& planning);

}  // namespace gsim::motion::linuxcnc
