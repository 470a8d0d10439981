#pragma once

#include <memory>

#include "motion/moves/path_builder.h"
#include "motion/moves/tracked_frame.h"
#include "motion/path/path_sink.h"
#include "motion/planner/active_machine.h"
#include "motion/planner/enqueue_result.h"
#include "motion/planner/motion_model.h"
#include "motion/planner/robot_position.h"
#include "motion/planner/timeline.h"

namespace gsim::motion {

/// Moves of a controller that does not stop at each target: its MotionModel may buffer them until it knows
/// those that follow. Without such a model no move is buffered.
class BufferedMoves {
  public:
    /// Makes the model of the machine's controller, if any. The references must outlive it.
    BufferedMoves(const ActiveMachine& machine, const TrackedFrame& tracked_frame, PathBuilder& paths,
                  Timeline& timeline, RobotPosition& position);
    BufferedMoves(const BufferedMoves&) = delete;
    BufferedMoves& operator=(const BufferedMoves&) = delete;

    /// Reports the paths of the model's moves to `path_sink` from now on, which must outlive this.
    void set_path_sink(PathSink& path_sink) { path_sink_ = &path_sink; }
    /// Returns the model; null if each move ends at standstill.
    MotionModel* model() { return model_.get(); }
    /// True if moves may end without a stop.
    bool can_pass_targets() const { return model_ != nullptr; }
    /// True if moves along lines and arcs of the joints are for the model now; none runs along a conveyor.
    bool accepts_moves() const { return model_ && !tracked_frame_.is_active(); }

    /// Enqueues a linear or circular move of the joints. Errors: those of PathBuilder::build() and of the
    /// model.
    EnqueueResult enqueue(const Move& move);
    /// Plans the model's pending moves to end at standstill.
    void plan_to_standstill();
    /// Does the same for motion without the model that follows.
    void leave();
    /// Returns the joint values at standstill after the last move.
    rrs::JointPos standstill_position() const;
    /// Drops the state of the model; it has no pending moves.
    void clear();
    /// Drops the pending moves, whose motion will not be made.
    void drop();

  private:
    const ActiveMachine& machine_;
    const TrackedFrame& tracked_frame_;
    PathBuilder& paths_;
    Timeline& timeline_;
    RobotPosition& position_;
    std::unique_ptr<MotionModel> model_;
    PathSink* path_sink_ = nullptr;
};

}  // namespace gsim::motion
