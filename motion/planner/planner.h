#pragma once

#include "motion/moves/buffered_moves.h"
#include "motion/moves/conveyors.h"
#include "motion/moves/dwells.h"
#include "motion/moves/exact_stop_moves.h"
#include "motion/moves/independent_moves.h"
#include "motion/moves/motion_stop.h"
#include "motion/moves/operator_overrides.h"
#include "motion/moves/path_builder.h"
#include "motion/moves/target_solver.h"
#include "motion/moves/tool_moves.h"
#include "motion/moves/tracked_frame.h"
#include "motion/planner/active_machine.h"
#include "motion/planner/enqueue_result.h"
#include "motion/planner/move.h"
#include "motion/planner/robot_position.h"
#include "motion/planner/timeline.h"

namespace gsim::motion {

/// Planner for machines without a planner of their manufacturer (thesis 5.3.2): moves, each a complete value,
/// become segments. Joint, linear and circular motion stops at each target (ExactStopMoves). Linear and
/// circular motion is made by a controller's MotionModel if the setup names a controller that does not stop
/// there (BufferedMoves), and as curved joint paths if the TCP would leave its path otherwise (ToolMoves).
///
/// Each move (and each dwell) becomes segments at the end of a Timeline: one, or with a model as many as it
/// makes of it. A full queue is RRS_QUEUE_FULL without a sink. A model may keep moves pending until it knows
/// those that follow: joint motion, dwells, flush(), a stop and step() past the end of the plan make it stop.
class Planner {
  public:
    /// Makes a planner. `sink`, if any, must outlive the planner, and must not call it while it takes a
    /// segment. Throws std::invalid_argument with the message of setup.validate() if that finds an error.
    explicit Planner(PlannerSetup setup, SegmentSink* sink = nullptr);
    Planner(const Planner&) = delete;
    Planner& operator=(const Planner&) = delete;

    /// Returns to the beginning: the clock at 0, an empty queue, no position, the machine unchanged.
    void restart();
    /// Sets the position of the robot, at standstill, before the next move; queued motion is finished first.
    /// Errors: those of TargetSolver::solve().
    PlanResult set_position(const Goal& goal);
    /// Enqueues a move. Errors: RRS_NO_INITIAL_POSITION, RRS_QUEUE_FULL, and those of TargetSolver::solve()
    /// and the planning.
    EnqueueResult enqueue(const Move& move);
    /// Enqueues a move that an event may end. Calls flush(), plans the move to its end at standstill and
    /// passes it to `search`, segment by segment. The motion is stopped as by MotionStop::stop() at the
    /// instant that `search` returns, and its remainder is dropped; then flush() follows.
    EnqueueResult enqueue_until(const Move& move, const StopSearch& search);
    /// Makes all queued segments final and passes them on; the step clock moves to their end. Continues a
    /// stopped motion.
    void flush();
    /// Moves the step clock on by a time; a position must be set.
    MotionStep step(double interpolation_s);

    /// Returns the end of the last planned segment; a model's pending moves do not count.
    double time_s() const { return timeline_.time_s(); }
    /// Returns the joint values at the last target; while a conveyor is tracked, in its frame.
    const rrs::JointPos& position() const { return position_.joints(); }
    bool has_position() const { return position_.is_set(); }
    /// Returns the target to which the motion from the step clock on leads; kNoTarget if none exists.
    rrs::TargetId current_target() const;

    ActiveMachine& machine() { return machine_; }
    const ActiveMachine& machine() const { return machine_; }
    const Timeline& timeline() const { return timeline_; }
    /// Returns the events, which a client may define.
    EventList& events() { return timeline_.events(); }
    const TargetSolver& targets() const { return targets_; }
    BufferedMoves& buffered_moves() { return buffered_moves_; }
    MotionStop& motion_stop() { return motion_stop_; }
    Dwells& dwells() { return dwells_; }
    const TrackedFrame& tracked_frame() const { return tracked_frame_; }
    Conveyors& conveyors() { return conveyors_; }
    IndependentMoves& independent_moves() { return independent_moves_; }
    const IndependentMoves& independent_moves() const { return independent_moves_; }

  private:
    PlanResult check_enqueue(const Move& move);
    EnqueueResult enqueue_motion(const Move& move);
    rrs::JointPos end_position() const;

    // Each part refers only to parts above it.
    ActiveMachine machine_;
    RobotPosition position_;
    Timeline timeline_;
    TrackedFrame tracked_frame_;
    TargetSolver targets_;
    PathBuilder paths_;
    BufferedMoves buffered_moves_;
    MotionStop motion_stop_;
    Dwells dwells_;
    OperatorOverrides overrides_;
    ExactStopMoves exact_stop_moves_;
    ToolMoves tool_moves_;
    Conveyors conveyors_;
    IndependentMoves independent_moves_;
};

}  // namespace gsim::motion
