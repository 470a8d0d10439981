#pragma once

#include <cstdint>

#include "machine/model/machine.h"
#include "motion/planner/overtravel_log.h"
#include "motion/planner/plan_error.h"
#include "runtime/monitors/violation_log.h"
#include "runtime/motion_sources/step_range_monitor.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/program/program_state.h"
#include "runtime/simulator/run_outcome.h"

namespace gsim::simulation {

/// Moves past the ranges of axes. A run then continues unless its limits end it.
class RangeViolations {
  public:
    /// Begins without violations. All arguments must outlive this.
    RangeViolations(const machine::Machine& machine, MachineMotion& motion, const ProgramState& program,
                    RunOutcome& outcome, ViolationLog& log);
    RangeViolations(const RangeViolations&) = delete;
    RangeViolations& operator=(const RangeViolations&) = delete;

    /// Begins a move. Returns the log that lets it pass ranges; null if moves may not.
    motion::OvertravelLog* begin_move();
    /// Checks the joints of a target for a controller module, which rejects a target past a range, or moves
    /// there.
    motion::PlanResult check_target(const rrs::JointPos& joints) const;
    /// Adds the violations of the move with the last target id, once it has been enqueued.
    void add_last(const SourceLocation& location);
    /// Returns false, with an alarm, if a step of a controller module has ended the run.
    bool check_steps();
    /// Adds the violations by steps of a controller module, or their alarm. Call it once, after the end of
    /// the run.
    void add_steps();

  private:
    bool returns_to_range(const motion::Overtravel& overtravel) const;
    Violation make_violation(std::size_t axis, double value, double limit) const;
    bool fail_out_of_range(const RangeExcess& step);

    const machine::Machine& machine_;
    MachineMotion& motion_;
    const ProgramState& program_;
    RunOutcome& outcome_;
    ViolationLog& log_;
    StepRangeMonitor steps_;               ///< For a controller module.
    rrs::JointPos move_start_;             ///< Start of the move being added.
    std::uint32_t axes_out_of_range_ = 0;  ///< By targets; bit 0: the first axis.
};

}  // namespace gsim::simulation
