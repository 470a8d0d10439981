#pragma once

#include "motion/moves/target_solver.h"
#include "motion/moves/tracked_frame.h"
#include "motion/planner/active_machine.h"
#include "motion/planner/motion_model.h"
#include "motion/planner/move.h"
#include "motion/planner/robot_position.h"

namespace gsim::motion {

/// Converts linear and circular moves of the joints into their paths.
class PathBuilder {
  public:
    /// Makes a builder for paths from `position` on. The references must outlive it.
    PathBuilder(const ActiveMachine& machine, const TrackedFrame& tracked_frame, const TargetSolver& targets,
                const RobotPosition& position)
        : machine_(machine), tracked_frame_(tracked_frame), targets_(targets), position_(position) {}

    /// Returns the path of a move from the robot's position. It is valid until the next call. Errors: those
    /// of the solver, RRS_CIRCLE_IMPOSSIBLE, RRS_MOTION_TYPE_NOT_SUPPORTED, RRS_MODE_NOT_SUPPORTED.
    tl::expected<const PathMove*, PlanError> build(const Move& move);
    /// Sets what counts on any path of the move that begins at the robot's position: all except the path.
    void set_parameters(const Move& move, PathMove& path) const;
    /// Checks that the machine can do circular motion. Errors: RRS_MOTION_TYPE_NOT_SUPPORTED;
    /// RRS_MODE_NOT_SUPPORTED for rapids.
    PlanResult check_circular(bool rapid) const;

  private:
    PlanResult build_path(const Move& move);
    PlanResult build_circle(const Move& move);
    PlanResult build_circle_about_center(const Move& move, const Circle& circle);

    const ActiveMachine& machine_;
    const TrackedFrame& tracked_frame_;
    const TargetSolver& targets_;
    const RobotPosition& position_;
    PathMove path_;  ///< Path of the last move; keeps its memory.
};

/// Returns the error of a circular move without a circle.
tl::unexpected<PlanError> no_via_point_error();

}  // namespace gsim::motion
