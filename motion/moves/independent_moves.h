#pragma once

#include "motion/moves/dwells.h"
#include "motion/moves/target_solver.h"
#include "motion/moves/tracked_frame.h"
#include "motion/planner/active_machine.h"
#include "motion/planner/move.h"
#include "motion/planner/robot_position.h"
#include "motion/planner/timeline.h"

namespace gsim::motion {

/// Joints that move independently of the moves of a planner (independent groups of axes).
class IndependentMoves {
  public:
    /// Makes moves for the end of `timeline`. The references must outlive it.
    IndependentMoves(const ActiveMachine& machine, const TrackedFrame& tracked_frame,
                     const MotionStop& motion_stop, const TargetSolver& targets,
                     BufferedMoves& buffered_moves, Dwells& dwells, Timeline& timeline,
                     RobotPosition& position);

    /// Moves joints independently to their values in `end` (IndependentMotion), from the end of the plan on,
    /// which is at standstill. Moves that follow do not wait for them. Errors: RRS_MODE_NOT_SUPPORTED while
    /// other joints move so, along a conveyor and if corners are rounded; RRS_INVALID_PARAMETER,
    /// RRS_JOINT_LIMIT.
    PlanResult enqueue(const rrs::JointPos& end);
    /// Returns the time at which the independent joints stop; 0 if none has moved.
    double end_s() const;
    /// Checks that a move needs no joint that moves independently at the end of the plan. Error:
    /// RRS_MODE_NOT_SUPPORTED.
    PlanResult check(const Move& move) const;

  private:
    const ActiveMachine& machine_;
    const TrackedFrame& tracked_frame_;
    const MotionStop& motion_stop_;
    const TargetSolver& targets_;
    BufferedMoves& buffered_moves_;
    Dwells& dwells_;
    Timeline& timeline_;
    RobotPosition& position_;
};

}  // namespace gsim::motion
