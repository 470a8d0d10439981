#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "machine/model/machine.h"
#include "motion/planner/plan_error.h"
#include "runtime/report/report.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/program/program_calls.h"
#include "runtime/simulator/program/target_ids.h"
#include "runtime/simulator/run_limits.h"

namespace gsim::simulation {

/// Outcome of a run: completed, or ended before its program by an alarm or a limit. The first alarm counts.
class RunOutcome {
  public:
    /// Begins without an alarm. All arguments but `limits` must outlive this.
    RunOutcome(const machine::Machine& machine, const RunLimits& limits, const MachineMotion& motion,
               const ProgramCalls& calls, const TargetIds& ids)
        : machine_(machine), limits_(limits), motion_(motion), calls_(calls), ids_(ids) {}

    const RunLimits& limits() const { return limits_; }
    RunStatus status() const { return status_; }
    /// Returns the alarm; no value if the run has not ended by one or by a limit.
    const std::optional<Alarm>& alarm() const { return alarm_; }
    /// Returns the number of executed blocks.
    std::uint64_t blocks() const { return blocks_; }

    /// Ends the run with an alarm of the program; always returns false.
    bool fail(text::DiagnosticKind kind, std::string message, const SourceLocation& location);
    /// Ends the run with an alarm in terms of the machine's axes for an error of the planner; always returns
    /// false.
    bool fail(const motion::PlanError& error, const SourceLocation& location);
    /// Ends the run with an alarm of a move that is running, whose source location and calls it gets. The
    /// machine reaches it before later parts of the program, so this alarm replaces another one. Always
    /// returns false.
    bool fail_during(const MoveInfo& move, Alarm alarm);
    /// Ends the run because of a limit; always returns false.
    bool stop(text::DiagnosticKind kind, std::string message, const SourceLocation& location);
    /// Ends the run because of the limit of machine time; always returns false.
    bool stop_for_time(const SourceLocation& location);

    /// Returns true if the planned motion is longer than the limit of machine time.
    bool is_past_max_time() const { return motion_.source().time_s() > limits_.max_time_s; }
    /// Counts a block; returns false past the limit (status stopped).
    bool count_block(const SourceLocation& location);
    /// Returns false if the run has used up its processor time (status stopped).
    bool has_cpu_time(const SourceLocation& location);

  private:
    bool fail_past_range(const machine::Axis& axis, const motion::PlanError& error,
                         const SourceLocation& location);

    const machine::Machine& machine_;
    RunLimits limits_;
    const MachineMotion& motion_;
    const ProgramCalls& calls_;
    const TargetIds& ids_;
    RunStatus status_ = RunStatus::completed;
    std::optional<Alarm> alarm_;
    std::uint64_t blocks_ = 0;
};

}  // namespace gsim::simulation
