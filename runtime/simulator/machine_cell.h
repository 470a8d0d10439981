#pragma once

#include <Eigen/Core>
#include <string_view>

#include "base/os/cpu_limit.h"
#include "controller/services/types.h"
#include "runtime/monitors/cell_monitor.h"
#include "runtime/report/report.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/moves/tcp_control.h"
#include "runtime/simulator/program/program_notifier.h"
#include "runtime/simulator/program/program_state.h"
#include "runtime/simulator/run_clock.h"

namespace gsim::simulation {

/// Cell of the machine in a run: its frames, which programs query and move, and its conveyors.
class MachineCell {
  public:
    /// Begins without a cell. All arguments must outlive this.
    MachineCell(MachineMotion& motion, RunClock& clock, ProgramState& program, TcpControl& tcp_control,
                const ProgramNotifier& notifier)
        : motion_(motion), clock_(clock), program_(program), tcp_control_(tcp_control), notifier_(notifier) {}

    /// Sets the cell, which was read for the machine and must outlive this, before the first move. Its checks
    /// end at the limit `cpu`; null: no limit.
    void set_monitor(CellMonitor& monitor, os::CpuLimit* cpu);
    /// Returns the monitor of the cell; null: no cell.
    CellMonitor* monitor() const { return monitor_; }
    /// Returns true if a cell file describes the cell.
    bool is_from_file() const { return monitor_ != nullptr && monitor_->use().is_from_file; }

    /// Writes the value of a frame of the cell; without a cell the controller's result.
    rrs::Status get_frame(std::string_view name, rrs::CartPos& frame);
    /// Moves a frame of the cell, or one of motion::MachineFrames, at the present point of the program. The
    /// machine comes to a standstill first. The controller moves the machine's own frames; without a cell it
    /// moves all.
    rrs::Status modify_frame(std::string_view name, const rrs::CartPos& frame);

    /// Returns true if the cell has conveyors, so their motion must be set.
    bool has_conveyors() const { return monitor_ != nullptr && monitor_->has_conveyors(); }
    /// Sets the motion of a conveyor of the cell, by its frame's name, from a time on; in the machine's
    /// world.
    void set_conveyor(std::string_view name, const Eigen::Vector3d& at_mm,
                      const Eigen::Vector3d& velocity_mm_s, double time_s);

    /// Adds contacts and near misses to a report. Call it once, after the end of the run.
    void add_findings(Report& report);

  private:
    bool uses_controller_frames() const { return controller_has_cell_ || !is_from_file(); }
    void machine_frame_changed(std::string_view name, const rrs::CartPos& frame);

    MachineMotion& motion_;
    RunClock& clock_;
    ProgramState& program_;
    TcpControl& tcp_control_;
    const ProgramNotifier& notifier_;
    CellMonitor* monitor_ = nullptr;
    bool controller_has_cell_ = false;  ///< Its services know the frames of the cell.
};

}  // namespace gsim::simulation
