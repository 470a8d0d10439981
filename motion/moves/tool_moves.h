#pragma once

#include <memory>
#include <vector>

#include "motion/moves/buffered_moves.h"
#include "motion/moves/dwells.h"
#include "motion/moves/path_builder.h"
#include "motion/moves/target_solver.h"
#include "motion/path/tool_path.h"
#include "motion/planner/active_machine.h"
#include "motion/planner/enqueue_result.h"
#include "motion/planner/robot_position.h"
#include "motion/planner/timeline.h"

namespace gsim::motion {

/// Moves with curved joint paths, so that the TCP follows a straight or circular path: under TCP control, and
/// to poses if slides alone do not carry the TCP.
class ToolMoves {
  public:
    /// Makes moves for the end of `timeline`. The references must outlive it.
    ToolMoves(const ActiveMachine& machine, const TargetSolver& targets, const PathBuilder& paths,
              BufferedMoves& buffered_moves, Dwells& dwells, Timeline& timeline, RobotPosition& position);
    ToolMoves(const ToolMoves&) = delete;
    ToolMoves& operator=(const ToolMoves&) = delete;

    /// True if the move is one of these.
    bool accepts(const Move& move) const;
    /// Enqueues such a move. Errors: those of the solver, of cut() and of the model; RRS_MODE_NOT_SUPPORTED,
    /// RRS_CIRCLE_IMPOSSIBLE.
    EnqueueResult enqueue(const Move& move);
    /// Drops the state of the model.
    void restart() { exact_stop_model_->clear(); }

  private:
    tl::expected<Eigen::Vector3d, PlanError> via_point(const Move& move) const;
    tl::expected<TcpPath, PlanError> make_tcp_path(const Move& move, const Eigen::Vector3d& from,
                                                   const Eigen::Vector3d& to) const;
    tl::expected<std::unique_ptr<ToolPath>, PlanError> make_tool_path(const Move& move) const;
    PlanResult add_sub_segments(const PathMove& full_move, const ToolPath& path,
                                const std::vector<PathSubSegment>& sub_segments);

    const ActiveMachine& machine_;
    const TargetSolver& targets_;
    const PathBuilder& paths_;
    BufferedMoves& buffered_moves_;
    Dwells& dwells_;
    Timeline& timeline_;
    RobotPosition& position_;
    /// Model of the sub-segments if that of the controller cannot plan them; it stops at the end.
    std::unique_ptr<MotionModel> exact_stop_model_;
};

}  // namespace gsim::motion
