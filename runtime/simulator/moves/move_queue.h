#pragma once

#include <vector>

#include "machine/model/machine.h"
#include "runtime/simulator/commands.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/moves/axis_groups.h"
#include "runtime/simulator/moves/move_acceptance.h"
#include "runtime/simulator/moves/move_feeds.h"
#include "runtime/simulator/moves/pose_solver.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/program_position.h"
#include "runtime/simulator/program/program_state.h"
#include "runtime/simulator/range_violations.h"
#include "runtime/simulator/run_outcome.h"
#include "runtime/simulator/warnings.h"

namespace gsim::simulation {

/// Moves of a program: gives each one to the controller as a motion::Move.
class MoveQueue {
  public:
    /// All arguments must outlive this.
    MoveQueue(const machine::Machine& machine, MachineMotion& motion, ProgramPosition& position,
              ProgramState& program, RunOutcome& outcome, RangeViolations& ranges, MoveAcceptance& acceptance,
              AxisGroups& groups, PoseSolver& poses, Warnings& warnings, const ProgramNotifier& notifier)
        : motion_(motion),
          position_(position),
          program_(program),
          outcome_(outcome),
          ranges_(ranges),
          acceptance_(acceptance),
          groups_(groups),
          poses_(poses),
          notifier_(notifier),
          feeds_(machine, position, outcome, warnings) {}

    // Each function enqueues a move. It returns false if an alarm or a limit has ended the run.

    bool enqueue(const LineMove& move);
    bool enqueue(const ArcMove& move);
    bool enqueue(const ViaMove& move);
    bool enqueue(const PoseMove& move);

    /// Returns the feeds, for moves that are enqueued elsewhere.
    MoveFeeds& feeds() { return feeds_; }

  private:
    void set_arc_axis(const PoseMove& move, const std::vector<motion::GroupJoint>& group_joints,
                      MoveInfo& info) const;
    motion::Move make_pose_move(const PoseMove& move, const MoveInfo& info,
                                const std::vector<motion::GroupJoint>& group_joints) const;

    MachineMotion& motion_;
    ProgramPosition& position_;
    ProgramState& program_;
    RunOutcome& outcome_;
    RangeViolations& ranges_;
    MoveAcceptance& acceptance_;
    AxisGroups& groups_;
    PoseSolver& poses_;
    const ProgramNotifier& notifier_;
    MoveFeeds feeds_;
};

}  // namespace gsim::simulation
