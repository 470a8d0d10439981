#pragma once

#include "motion/moves/buffered_moves.h"
#include "motion/moves/operator_overrides.h"
#include "motion/moves/path_builder.h"
#include "motion/moves/target_solver.h"
#include "motion/moves/tracked_frame.h"
#include "motion/planner/active_machine.h"
#include "motion/planner/enqueue_result.h"
#include "motion/planner/robot_position.h"
#include "motion/planner/timeline.h"

namespace gsim::motion {

/// Moves from standstill to standstill without a controller's model: joint motion, and linear and circular
/// motion of controllers that stop at each target, or along a conveyor.
///
/// Mixed moves: the path of the position joints is the master, by the programmed speed. Each other joint
/// follows by its own fastest ramps. The slowest of all sets the time, and the others run slower to take as
/// long. The rotary joints of a via point are not checked. Each joint of a rapid moves uncoordinated
/// (uncoordinated_move.h) if rapids are not interpolated, even with TCP control or a pose: these are for
/// feeds. A move to the current position becomes a segment of no duration, so that target ids arrive complete
/// and in order.
class ExactStopMoves {
  public:
    /// Makes moves for the end of `timeline`. The references must outlive it.
    ExactStopMoves(const ActiveMachine& machine, const TrackedFrame& tracked_frame,
                   const TargetSolver& targets, PathBuilder& paths, BufferedMoves& buffered_moves,
                   OperatorOverrides& overrides, Timeline& timeline, RobotPosition& position);

    /// Enqueues a move of the joints to a target, each within its limits. Errors: those of the solver and the
    /// planning.
    EnqueueResult enqueue_joint_move(const Move& move);
    /// Enqueues a linear or circular move of the joints. Errors: those of PathBuilder::build() and the
    /// planning; RRS_MODE_NOT_SUPPORTED for uncoordinated rapids along a conveyor.
    EnqueueResult enqueue_path_move(const Move& move);

  private:
    const ActiveMachine& machine_;
    const TrackedFrame& tracked_frame_;
    const TargetSolver& targets_;
    PathBuilder& paths_;
    BufferedMoves& buffered_moves_;
    OperatorOverrides& overrides_;
    Timeline& timeline_;
    RobotPosition& position_;
};

}  // namespace gsim::motion
