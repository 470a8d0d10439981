#pragma once

#include <array>
#include <memory>

#include "controller/services/types.h"
#include "motion/path/arc.h"
#include "motion/planner/move_rules.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

/// Sub-segment of a curved joint path that a line of the joints approximates (tool_moves.h).
struct ToolSubSegment {
    JointRole role = JointRole::position;  ///< Measure of the path: that of the tool, or how far it turns.
    double length = 0;                     ///< mm or rad
    rrs::JointPos joint_curvature;  ///< Second derivative of the joints by that path, without sign: mm or rad
                                    ///< per length^2.
};

/// Move as a controller's planner gets it: the path, and what the program requests on it.
struct PathMove {
    rrs::TargetId target_id = 0;
    SegmentKind kind = SegmentKind::linear;  ///< linear or circular
    rrs::JointPos start;                     ///< End of the previous move, mm or rad.
    rrs::JointPos end;
    Arc arc;  ///< Arc of a circular move, in the position joints; the other joints move in proportion.
    /// Path of the joints that turn the tool, evenly with the tool path; null: in proportion.
    std::shared_ptr<const OrientationArc> orientation;
    /// Null: the joints move along straight paths by themselves.
    std::shared_ptr<const ToolSubSegment> sub_segment;
    bool reaches_target = true;  ///< Ends at its target; else another move leads on to it.
    double share = 1;            ///< Share of a program block that has become several moves.
    double length_mm = 0;        ///< Length of the tool path; 0 if only rotary joints move.
    MoveRules rules;  ///< Programmed speeds and the path's limits, without the operator's overrides.
    EnabledOverrides enabled_overrides;
    bool rapid = false;
    rrs::PathMode mode = rrs::PathMode::exact_stop;
    double tolerance_mm =
        0;  ///< In continuous mode: how far corners may be cut; 0: as far as the controller does.
    double merge_tolerance_mm = 0;  ///< In continuous mode: lines may be merged that lie within this.
};

/// Destination of a model's finished segments, in the order of time.
class SegmentOutput {
  public:
    virtual ~SegmentOutput() = default;
    /// Returns the slot of the next segment with its previous content, except for its target and its position
    /// joints: no followers, no superimposed motion, no orientation path, no deviation. The model fills in
    /// kind, start, end, arc, length_mm, duration_s and master.
    virtual Segment& begin(rrs::TargetId id) = 0;
    /// Notes that the slot of begin() is filled: the segment starts at the end of the previous one.
    virtual void finish() = 0;
    /// Returns the end of the last segment, on the planner's clock.
    virtual double time_s() const = 0;
};

/// Method by which a controller turns moves into motion. It may keep moves pending until it knows those that
/// follow. Segments come out in the order of the moves, and each move's before those of the next.
class MotionModel {
  public:
    virtual ~MotionModel() = default;
    /// Adds a move. Errors: RRS_ZERO_SPEED, RRS_INVALID_PARAMETER; then no change was made, except for chords
    /// of an arc before one that is rejected.
    virtual PlanResult add(const PathMove& move) = 0;
    /// Plans the pending moves to end at standstill, and outputs them.
    virtual void plan_to_standstill() = 0;
    /// Drops the pending moves.
    virtual void clear() = 0;
    /// Returns the end of the motion with a last move that ended at `position`. It is off that if the model
    /// rounds positions or leaves out paths that are too short.
    virtual rrs::JointPos end_position_of(const rrs::JointPos& position) const { return position; }
};

}  // namespace gsim::motion
