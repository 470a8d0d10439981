#pragma once

#include <cstdint>
#include <optional>

#include "machine/model/machine.h"
#include "runtime/monitors/process_monitor.h"
#include "runtime/report/recorder.h"
#include "runtime/simulator/program/target_ids.h"

namespace gsim::simulation {

/// State of the machine's process (for example its jet) as the program switches it, and the monitor of its
/// use.
class ProcessState {
  public:
    /// Begins with the process off; `recorder` feeds the monitor. All arguments must outlive this.
    ProcessState(const machine::Machine& machine, Recorder& recorder, const TargetIds& ids);
    ProcessState(const ProcessState&) = delete;
    ProcessState& operator=(const ProcessState&) = delete;

    /// Switches the process on or off in the moves that follow; `with_motion`: from the next one on that is
    /// no dwell.
    void set(bool on, bool with_motion);
    /// Writes the state into a move that is about to be enqueued.
    void begin_move(MoveInfo& info);
    /// Ends the program here, by one of its own words: an active process is switched off.
    void end_program(const SourceLocation& location);
    /// Ends the run after the last move: a process that is still on is a finding.
    void end_run();
    /// Returns the findings. Call it once, after the end of the run.
    ProcessFindings release() { return monitor_.release(); }

  private:
    const machine::Machine& machine_;
    const TargetIds& ids_;
    ProcessMonitor monitor_;
    bool on_ = false;
    std::uint32_t switches_ = 0;
    std::optional<bool> on_with_motion_;  ///< Value from the next move on.
};

}  // namespace gsim::simulation
