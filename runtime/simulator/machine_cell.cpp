#include "runtime/simulator/machine_cell.h"

#include <fmt/format.h>

#include "motion/kinematics/pose.h"

namespace gsim::simulation {

void MachineCell::set_monitor(CellMonitor& monitor, os::CpuLimit* cpu) {
    monitor_ = &monitor;
    monitor.set_time_limit(cpu);
    controller_has_cell_ = motion_.source().set_cell(monitor);
    if (monitor.use().monitored) motion_.recorder().add_output(monitor);
}

rrs::Status MachineCell::get_frame(std::string_view name, rrs::CartPos& frame) {
    if (uses_controller_frames()) return motion_.source().shell().GetCellFrame(name, frame);
    const auto found = monitor_->frame(name, motion_.source().time_s());
    if (!found) return found.error().status;
    frame = *found;
    return rrs::Status::RRS_SUCCESS;
}

rrs::Status MachineCell::modify_frame(std::string_view name, const rrs::CartPos& frame) {
    const bool is_machine_frame = motion::MachineFrames::has(name);
    if (is_machine_frame && !controller_has_cell_ && !kinematics::check_pose(frame))
        return rrs::Status::RRS_INVALID_PARAMETER;
    if (!uses_controller_frames() || is_machine_frame) clock_.wait();
    if (uses_controller_frames() || is_machine_frame) {
        const rrs::Status status = motion_.source().shell().ModifyCellFrame(name, frame);
        if (rrs::is_error_status(status) || !is_machine_frame) return status;
    }
    if (monitor_ != nullptr && !controller_has_cell_) {
        const motion::PlanResult moved = monitor_->move_frame(name, frame, motion_.source().time_s());
        if (!moved) return moved.error().status;
    }
    if (is_machine_frame) machine_frame_changed(name, frame);
    return rrs::Status::RRS_SUCCESS;
}

/// Values relative to the tool centre point move along with it.
void MachineCell::machine_frame_changed(std::string_view name, const rrs::CartPos& frame) {
    program_.machine_frames().set(name, frame);
    program_.tool().update_tcp();
    notifier_.notify_unrecordable("the script moves a frame of the machine, 'tool' or 'base'");
    tcp_control_.renew(program_.ids().last_location());
}

void MachineCell::set_conveyor(std::string_view name, const Eigen::Vector3d& at_mm,
                               const Eigen::Vector3d& velocity_mm_s, double time_s) {
    if (monitor_ == nullptr) return;
    cell::UniformMotion uniform_motion{.from_s = time_s, .velocity_mm_s = velocity_mm_s};
    uniform_motion.pose.translation() = at_mm;
    monitor_->set_conveyor(name, uniform_motion);
}

void MachineCell::add_findings(Report& report) {
    if (monitor_ == nullptr || !monitor_->use().monitored) return;
    report.cell = monitor_->release();
    if (report.cell->dropped == 0) return;
    report.messages.warnings.push_back(
        fmt::format("{} more contacts and near misses are not listed in the report", report.cell->dropped));
}

}  // namespace gsim::simulation
