#pragma once

#include <optional>
#include <string>

#include "controller/module/rcs_host.h"
#include "machine/model/machine.h"
#include "runtime/report/report.h"
#include "runtime/simulator/controller_services.h"
#include "runtime/simulator/machine_cell.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/moves/axis_groups.h"
#include "runtime/simulator/moves/dwell_queue.h"
#include "runtime/simulator/moves/move_acceptance.h"
#include "runtime/simulator/moves/move_queue.h"
#include "runtime/simulator/moves/pose_solver.h"
#include "runtime/simulator/moves/probing.h"
#include "runtime/simulator/moves/tcp_control.h"
#include "runtime/simulator/program/program_events.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/program_position.h"
#include "runtime/simulator/program/program_state.h"
#include "runtime/simulator/program_observer.h"
#include "runtime/simulator/run_clock.h"
#include "runtime/simulator/run_limits.h"
#include "runtime/simulator/run_monitors.h"
#include "runtime/simulator/run_outcome.h"
#include "runtime/simulator/run_violations.h"
#include "runtime/simulator/warnings.h"

namespace gsim::simulation {

/// Run of one machine: accepts moves, dwells and events in the order of the program, plans them through the
/// services of its controller, and records the result. It does not depend on the language of the program.
///
/// It makes the parts of a run, connects them, and combines their results in a report. Functions of parts
/// that can fail return false; then outcome() has the alarm, and the run must end.
class Simulator {
  public:
    /// Makes a run with the machine at its home. Its controller is `module`, made for
    /// make_planner_setup(machine), or our own planner. Throws std::invalid_argument if the planner does not
    /// support the machine.
    Simulator(machine::Machine machine, RunLimits limits, std::optional<rrs::RcsModule> module = {});
    Simulator(const Simulator&) = delete;
    Simulator& operator=(const Simulator&) = delete;

    /// Adds an output, which must outlive the simulator, before the first move.
    void add_output(RunOutput& output) { motion_.recorder().add_output(output); }
    /// Sets the cell of the machine, which was read for it and must outlive the simulator, before the first
    /// move.
    void set_cell(CellMonitor& cell) { cell_.set_monitor(cell, outcome_.limits().cpu); }
    /// Sets an observer of the program's requests, which must outlive the simulator, before the first move;
    /// one at most.
    void set_observer(ProgramObserver& observer);

    const machine::Machine& machine() const { return machine_; }
    Warnings& warnings() { return warnings_; }
    const ProgramNotifier& notifier() const { return notifier_; }
    /// Returns the controller and the receivers of its segments.
    MachineMotion& motion() { return motion_; }
    const MachineMotion& motion() const { return motion_; }
    /// Returns the position at the end of the last move.
    const ProgramPosition& position() const { return position_; }
    RunClock& clock() { return clock_; }
    /// Returns what the program has selected for its moves.
    ProgramState& program() { return program_; }
    const ProgramState& program() const { return program_; }
    /// Returns the alarm and the limits of the run.
    RunOutcome& outcome() { return outcome_; }
    const RunOutcome& outcome() const { return outcome_; }
    ProgramEvents& events() { return events_; }
    RunMonitors& monitors() { return monitors_; }
    const RunMonitors& monitors() const { return monitors_; }
    TcpControl& tcp_control() { return tcp_control_; }
    MachineCell& cell() { return cell_; }
    const MachineCell& cell() const { return cell_; }
    DwellQueue& dwells() { return dwells_; }
    AxisGroups& groups() { return groups_; }
    PoseSolver& poses() { return poses_; }
    MoveQueue& moves() { return moves_; }
    Probing& probing() { return is_probing_; }
    /// Returns the services of the controller for clients that call them by themselves.
    ControllerServices& services() { return services_; }

    /// Finishes all motion and returns the report of a program of this name. Call it once.
    Report finish(std::string program);

  private:
    void start();
    void end_motion();

    machine::Machine machine_;
    Warnings warnings_;
    ProgramNotifier notifier_;
    MachineMotion motion_;
    ProgramPosition position_;
    RunClock clock_;
    ProgramState program_;
    RunOutcome outcome_;
    ProgramEvents events_;
    RunViolations violations_;
    RunMonitors monitors_;
    TcpControl tcp_control_;
    MachineCell cell_;
    MoveAcceptance acceptance_;
    DwellQueue dwells_;
    AxisGroups groups_;
    PoseSolver poses_;
    MoveQueue moves_;
    Probing is_probing_;
    ControllerServices services_;
};

}  // namespace gsim::simulation
