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

/// What a line of the joints stands for that is a piece of a curved way of theirs (tool_moves.h).
struct ToolPiece {
    JointRole role = JointRole::position;  ///< The measure of the way: the tool's, or how far it turns.
    double length = 0;                     ///< mm or rad
    rrs::JointPos
        bend;  ///< Second derivative of the joints by that way, without sign: mm or rad per length^2.
};

/// A move as a controller's planner gets it: the way, and what the program asks for on it.
struct PathMove {
    rrs::TargetId target_id = 0;
    SegmentKind kind = SegmentKind::linear;  ///< linear or circular
    rrs::JointPos start;                     ///< Where the move before ended, mm or rad.
    rrs::JointPos end;
    Arc arc;  ///< Of a circular move, in the position joints; the other joints go in proportion.
    /// The way of the joints that turn the tool, evenly with the tool's way; null: in proportion.
    std::shared_ptr<const OrientationArc> orientation;
    /// Null: the joints go straight ways by themselves.
    std::shared_ptr<const ToolPiece> piece;
    bool reaches_target = true;  ///< Ends at its target; else another move leads on to it.
    double share = 1;            ///< Of a block of the program that has become several moves.
    double length_mm = 0;        ///< Of the tool's way; 0 where rotary joints alone move.
    MoveRules rules;  ///< Programmed speeds and the path's limits, without the operator's overrides.
    ObeyedOverrides obeyed;
    bool rapid = false;
    rrs::PathMode mode = rrs::PathMode::exact_stop;
    double tolerance_mm =
        0;  ///< In continuous mode: how far corners may be cut; 0: as far as the controller does.
    double merge_tolerance_mm = 0;  ///< In continuous mode: lines may be merged that lie within this.
};

/// Where a model puts finished segments, in the order of time.
class SegmentOutput {
  public:
    virtual ~SegmentOutput() = default;
    /// The slot of the next segment, with what it held before but for its target and its position joints: no
    /// followers, nothing beside it, no way of orientation, no deviation. The model fills in kind, start,
    /// end, arc, length_mm, duration_s and lead.
    virtual Segment& begin(rrs::TargetId id) = 0;
    /// The slot that begin() gave is filled: the segment starts where the one before ends.
    virtual void finish() = 0;
    /// The end of the last segment, on the planner's clock.
    virtual double time_s() const = 0;
};

/// How a controller turns moves into motion. It may hold moves back until it knows those that follow;
/// segments come out in the order of the moves, and each move's before those of the next.
class MotionModel {
  public:
    virtual ~MotionModel() = default;
    /// RRS_ZERO_SPEED, RRS_INVALID_PARAMETER; then nothing has changed, but for chords of an arc before one
    /// that is refused.
    virtual Planned add(const PathMove& move) = 0;
    /// Plans what is held back to end at rest, and puts it out.
    virtual void come_to_rest() = 0;
    /// Forgets what is held back.
    virtual void clear() = 0;
    /// Where the motion ends whose last move ended at `position`: off it where the model rounds positions or
    /// leaves out ways that are too short.
    virtual rrs::JointPos standing_at(const rrs::JointPos& position) const { return position; }
};

}  // namespace gsim::motion
