#pragma once

#include "motion/moves/tracked_frame.h"
#include "motion/planner/active_machine.h"
#include "motion/planner/motion_model.h"
#include "motion/planner/timeline.h"

namespace gsim::motion {

/// Operator's overrides in motion from standstill to standstill. Models follow them themselves.
class OperatorOverrides {
  public:
    /// Makes the overrides of the machine's schedule. The references must outlive it.
    OperatorOverrides(const ActiveMachine& machine, TrackedFrame& tracked_frame, Timeline& timeline)
        : machine_(machine), tracked_frame_(tracked_frame), timeline_(timeline) {}

    /// Returns the overrides at the end of the timeline.
    Overrides current() const;
    /// Returns the share of the programmed speed for the next move; a hold has ended before it begins.
    double current_share(const EnabledOverrides& enabled_overrides, bool rapid) const;
    /// Appends a standstill at `position` until the operator lets a move run.
    void wait_out_hold(rrs::TargetId id, const rrs::JointPos& position,
                       const EnabledOverrides& enabled_overrides, bool rapid);
    /// Returns the machine for a move under the current overrides, valid until the next call: with the speeds
    /// that a conveyor leaves, or with the accelerations of MoveLimits. Errors: those of MoveLimits.
    tl::expected<const PlannerSetup*, PlanError> setup_for_move(const PathMove& path);
    /// Adds the segment in the slot of begin(), which moves along a path from standstill to standstill: in
    /// parts if the operator changes an override during it. The next motion is the first to obey if joints
    /// have laws of their own, or the complete motion has a time.
    void finish(const PathMove& path, Segment& segment);

  private:
    struct ActiveMove;

    bool emit_next_part(ActiveMove& active_move);
    void emit_part(ActiveMove& active_move, const TimeLaw& law, double t_s);
    void plan_remainder(ActiveMove& active_move, double start_speed);

    const ActiveMachine& machine_;
    TrackedFrame& tracked_frame_;
    Timeline& timeline_;
    PlannerSetup limited_setup_;  ///< The machine with the accelerations of one move (MoveLimits).
};

}  // namespace gsim::motion
