#pragma once

#include <cstddef>
#include <vector>

#include "machine/model/machine.h"
#include "motion/planner/move.h"
#include "runtime/simulator/commands.h"
#include "runtime/simulator/event_log.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/moves/dwell_queue.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/program_position.h"
#include "runtime/simulator/program/target_ids.h"
#include "runtime/simulator/range_violations.h"
#include "runtime/simulator/run_clock.h"
#include "runtime/simulator/run_outcome.h"

namespace gsim::simulation {

/// Groups of axes of a machine in a run: coordinated with moves to poses, or independent.
class AxisGroups {
  public:
    /// Begins with the motions of the machine file. All arguments must outlive this.
    AxisGroups(const machine::Machine& machine, MachineMotion& motion, RunClock& clock,
               ProgramPosition& position, TargetIds& ids, RunOutcome& outcome, RangeViolations& ranges,
               DwellQueue& dwells, EventLog& events, const ProgramNotifier& notifier);

    /// Returns how a group of the machine, by its index, moves during moves to poses.
    machine::GroupMotion motion(std::size_t group) const { return motions_[group]; }
    void set_motion(std::size_t group, machine::GroupMotion motion) { motions_[group] = motion; }
    /// Returns the joints of axes of groups during a move to a pose.
    std::vector<motion::GroupJoint> joints(const std::vector<GroupTarget>& targets) const;

    /// Moves axes of a group independently, as fast as they can; the machine comes to a standstill before.
    /// Moves that follow do not wait for them, unless they move these axes themselves. One group moves at a
    /// time: another one waits. Returns false if the run has ended.
    bool move(std::size_t group, const std::vector<GroupTarget>& targets, const SourceLocation& location);
    /// Dwells until no group moves independently. Returns false if the run has ended.
    bool wait(const SourceLocation& location);
    /// Dwells likewise if a move to these axis values moves axes of such a group.
    bool wait_before(const AxisVector& target, const SourceLocation& location);
    bool wait_before(const PoseMove& move);

  private:
    const machine::Machine& machine_;
    MachineMotion& motion_;
    RunClock& clock_;
    ProgramPosition& position_;
    TargetIds& ids_;
    RunOutcome& outcome_;
    RangeViolations& ranges_;
    DwellQueue& dwells_;
    EventLog& events_;
    const ProgramNotifier& notifier_;
    std::vector<machine::GroupMotion> motions_;  ///< For the machine's groups, as the program has set them.
    std::vector<std::size_t> independent_axes_;  ///< Axes that may be moving independently.
};

}  // namespace gsim::simulation
