#pragma once

#include "motion/moves/tracked_frame.h"
#include "motion/planner/active_machine.h"
#include "motion/planner/move.h"
#include "motion/planner/robot_position.h"

namespace gsim::motion {

/// Computes the joint values of targets.
class TargetSolver {
  public:
    /// Makes a solver for the active machine, of which the references must outlive it.
    TargetSolver(const ActiveMachine& machine, const TrackedFrame& tracked_frame,
                 const RobotPosition& position)
        : machine_(machine), tracked_frame_(tracked_frame), position_(position) {}

    /// Computes the joint values of a position; for a pose those nearest to the last target. Errors:
    /// RRS_INVALID_PARAMETER, RRS_NO_SOLUTION, RRS_JOINT_LIMIT.
    PlanResult solve(const Goal& goal, rrs::JointPos& joints) const;
    /// Checks that they are values for the joints of this machine, independent of their ranges. Error:
    /// RRS_INVALID_PARAMETER.
    PlanResult check_joints(const rrs::JointPos& joints) const;

  private:
    PlanResult solve_pose(const PoseGoal& goal, rrs::JointPos& joints) const;

    const ActiveMachine& machine_;
    const TrackedFrame& tracked_frame_;
    const RobotPosition& position_;
};

}  // namespace gsim::motion
