#pragma once

#include <optional>

#include "motion/path/conveyor_frame.h"
#include "motion/planner/active_machine.h"
#include "motion/planner/timeline.h"

namespace gsim::motion {

/// Frame of the conveyor that a planner tracks, if it tracks one: targets are given in it, and its motion is
/// superimposed on that of the machine.
class TrackedFrame {
  public:
    /// Makes one without a conveyor. `machine` and `timeline` must outlive it.
    TrackedFrame(const ActiveMachine& machine, const Timeline& timeline)
        : machine_(machine), timeline_(timeline) {}

    /// Tracks a conveyor for the segments that follow.
    void enter(int conveyor, ConveyorFrame frame);
    /// Ends tracking at the end of the timeline.
    void leave();
    /// Returns to the state without a conveyor.
    void restart();

    bool is_active() const { return tracking_.has_value(); }
    bool is_of(int conveyor) const { return tracking_ && tracking_->conveyor == conveyor; }
    /// True if the step clock is at a time at which a conveyor is tracked, or was.
    bool is_active_at_step_clock() const { return tracking_ || timeline_.step_time_s() < left_s_; }
    /// Returns the frame; one must be tracked.
    const ConveyorFrame& frame() const { return tracking_->frame; }
    /// Returns what the frame adds to joint values at the end of the timeline; one must be tracked.
    rrs::JointPos shift_at_end() const { return tracking_->frame.shift(timeline_.time_s()); }
    /// Returns the machine for the next motion: with the speeds that the conveyor leaves, if one is tracked.
    const PlannerSetup& setup_for_motion();
    /// Converts a segment in the frame into one of the machine, if a conveyor is tracked.
    void superimpose(Segment& segment) const;
    /// Does the same and checks the joint ranges on the path. Error: RRS_JOINT_LIMIT.
    PlanResult superimpose_in_range(Segment& segment) const;

  private:
    struct Tracking {
        int conveyor;
        ConveyorFrame frame;
        PlannerSetup setup;  ///< Machine with the speed that the conveyor leaves.
    };

    const ActiveMachine& machine_;
    const Timeline& timeline_;
    std::optional<Tracking> tracking_;
    double left_s_ = 0;  ///< When the last one was left.
};

}  // namespace gsim::motion
