#pragma once

#include <Eigen/Core>
#include <optional>

#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/program_position.h"
#include "runtime/simulator/program/tool_offset.h"
#include "runtime/simulator/run_clock.h"
#include "runtime/simulator/run_outcome.h"

namespace gsim::simulation {

/// TCP control as the program switches it (G43.4). While it is on, the position of the program and all
/// targets are coordinates of the TCP (TcpFrame).
class TcpControl {
  public:
    /// Begins without TCP control. All arguments must outlive this.
    TcpControl(MachineMotion& motion, RunClock& clock, ProgramPosition& position, const ToolOffset& tool,
               RunOutcome& outcome, const ProgramNotifier& notifier)
        : motion_(motion),
          clock_(clock),
          position_(position),
          tool_(tool),
          outcome_(outcome),
          notifier_(notifier) {}

    /// Sets TCP control for the moves that follow, with a tool length offset of the linear axes X, Y and Z in
    /// mm; no value: off. The machine comes to a standstill. Returns false on an alarm.
    bool set(const std::optional<Eigen::Vector3d>& offset_mm, const SourceLocation& location);
    bool is_on() const { return position_.tcp_frame().has_value(); }
    /// Sets the same offset again if it is on, once the machine's frames have changed. Returns false on an
    /// alarm.
    bool renew(const SourceLocation& location);

  private:
    MachineMotion& motion_;
    RunClock& clock_;
    ProgramPosition& position_;
    const ToolOffset& tool_;
    RunOutcome& outcome_;
    const ProgramNotifier& notifier_;
    Eigen::Vector3d offset_mm_ = Eigen::Vector3d::Zero();
};

}  // namespace gsim::simulation
