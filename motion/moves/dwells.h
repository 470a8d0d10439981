#pragma once

#include "motion/moves/buffered_moves.h"
#include "motion/moves/motion_stop.h"
#include "motion/moves/tracked_frame.h"
#include "motion/planner/active_machine.h"
#include "motion/planner/timeline.h"

namespace gsim::motion {

/// Standstill in a plan: programmed dwells, and the time in which the controller waits for its program.
class Dwells {
  public:
    /// Makes one for a plan that has no motion yet. The references must outlive it.
    Dwells(const ActiveMachine& machine, const TrackedFrame& tracked_frame, const MotionStop& motion_stop,
           BufferedMoves& buffered_moves, Timeline& timeline)
        : machine_(machine),
          tracked_frame_(tracked_frame),
          motion_stop_(motion_stop),
          buffered_moves_(buffered_moves),
          timeline_(timeline) {}

    /// Enqueues a dwell from 0 to kMaxDuration_s. Errors: RRS_INVALID_PARAMETER, RRS_QUEUE_FULL,
    /// RRS_NO_INITIAL_POSITION.
    PlanResult enqueue(rrs::TargetId id, double dwell_s);
    /// Appends a programmed dwell, as the controller counts it, to follow the motion enqueued so far.
    void append(rrs::TargetId id, double dwell_s);
    /// Plans a model's pending moves to end at standstill. The controller then waits for its program if
    /// `waits`, which takes its dwell_s if anything has moved since it did so last.
    void plan_to_standstill(bool waits = false);
    /// Does the same at the end of a program. Its last positions pass through the controller's position loop.
    void plan_to_final_standstill();
    /// Returns to the state before all motion.
    void restart() { last_wait_s_ = 0; }

  private:
    void append_exactly(rrs::TargetId id, double dwell_s);
    double counted_s(double programmed_s) const;

    const ActiveMachine& machine_;
    const TrackedFrame& tracked_frame_;
    const MotionStop& motion_stop_;
    BufferedMoves& buffered_moves_;
    Timeline& timeline_;
    double last_wait_s_ = 0;  ///< When the controller waited for its program last.
};

}  // namespace gsim::motion
