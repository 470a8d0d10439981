#pragma once

#include <optional>
#include <vector>

#include "motion/moves/buffered_moves.h"
#include "motion/moves/tracked_frame.h"
#include "motion/planner/active_machine.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/robot_position.h"
#include "motion/planner/timeline.h"

namespace gsim::motion {

/// Stop of the motion at the instant of the step clock, and what follows it. No moves are accepted while a
/// motion is stopped.
class MotionStop {
  public:
    /// Makes one without a stopped motion. The references must outlive it.
    MotionStop(const ActiveMachine& machine, const TrackedFrame& tracked_frame, BufferedMoves& buffered_moves,
               Timeline& timeline, RobotPosition& position)
        : machine_(machine),
          tracked_frame_(tracked_frame),
          buffered_moves_(buffered_moves),
          timeline_(timeline),
          position_(position) {}

    /// Brakes from the instant of the step clock, each joint within its limits (stop.h), over as many
    /// segments as it takes; steps then continue to the stop. Moves are rejected until resume() or cancel().
    /// Errors: RRS_MODE_NOT_SUPPORTED along a conveyor, RRS_NO_INITIAL_POSITION.
    PlanResult stop();
    /// Continues a stopped motion.
    void resume();
    /// Drops the remainder of a stopped motion, and what is queued behind it.
    void cancel();
    /// Returns to the state without a stopped motion.
    void restart() { stopped_.reset(); }

    bool is_stopped() const { return stopped_.has_value(); }
    /// Returns the joint values at which a stopped motion comes to its stop; nullopt if none is stopped.
    std::optional<rrs::JointPos> position() const;
    /// Returns the target of the remainder of a stopped motion; nullopt if nothing remains.
    std::optional<rrs::TargetId> remaining_target() const;
    /// Checks that a move may be enqueued now. Errors: RRS_NO_INITIAL_POSITION; RRS_QUEUE_FULL while a motion
    /// is stopped.
    PlanResult check_ready_for_move() const;

  private:
    struct StopState {
        std::vector<Segment> remainder;
        rrs::JointPos position;
    };

    const ActiveMachine& machine_;
    const TrackedFrame& tracked_frame_;
    BufferedMoves& buffered_moves_;
    Timeline& timeline_;
    RobotPosition& position_;
    std::optional<StopState> stopped_;
};

}  // namespace gsim::motion
