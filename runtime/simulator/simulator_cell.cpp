// Cell of the machine of a Simulator.

#include <fmt/format.h>

#include "motion/kinematics/pose.h"
#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

void Simulator::set_cell(CellMonitor& cell) {
    cell_ = &cell;
    cell.set_time_limit(limits_.cpu);
    controller_has_cell_ = motion_->set_cell(cell);
    if (cell.use().monitored) recorder_.add_output(cell);
}

rrs::Status Simulator::get_cell_frame(std::string_view name, rrs::CartPos& frame) {
    if (uses_controller_frames()) return shell().GetCellFrame(name, frame);
    const auto found = cell_->frame(name, motion_->time_s());
    if (!found) return found.error().status;
    frame = *found;
    return rrs::Status::RRS_SUCCESS;
}

rrs::Status Simulator::modify_cell_frame(std::string_view name, const rrs::CartPos& frame) {
    const bool is_machine_frame = motion::MachineFrames::has(name);
    if (is_machine_frame && !controller_has_cell_ && !kinematics::check_pose(frame))
        return rrs::Status::RRS_INVALID_PARAMETER;
    if (!uses_controller_frames() || is_machine_frame) wait();
    if (uses_controller_frames() || is_machine_frame) {
        const rrs::Status status = shell().ModifyCellFrame(name, frame);
        if (rrs::is_error_status(status) || !is_machine_frame) return status;
    }
    if (cell_ != nullptr && !controller_has_cell_) {
        const motion::PlanResult moved = cell_->move_frame(name, frame, motion_->time_s());
        if (!moved) return moved.error().status;
    }
    if (is_machine_frame) machine_frame_changed(name, frame);
    return rrs::Status::RRS_SUCCESS;
}

/// Values relative to the tool centre point move along with it.
void Simulator::machine_frame_changed(std::string_view name, const rrs::CartPos& frame) {
    machine_frames_.set(name, frame);
    update_tcp();
    if (observer_ != nullptr)
        observer_->on_unrecordable_motion("the script moves the machine's own frame, 'tool' or 'base'");
    if (tcp_frame_) set_tcp_control(Eigen::Vector3d(tcp_offset_mm_), last_location_);
}

void Simulator::set_conveyor(std::string_view name, const Eigen::Vector3d& at_mm,
                             const Eigen::Vector3d& velocity_mm_s, double time_s) {
    if (cell_ == nullptr) return;
    cell::UniformMotion uniform_motion{.from_s = time_s, .velocity_mm_s = velocity_mm_s};
    uniform_motion.pose.translation() = at_mm;
    cell_->set_conveyor(name, uniform_motion);
}

void Simulator::add_cell_findings(Report& report) {
    if (cell_ == nullptr || !cell_->use().monitored) return;
    report.cell = cell_->release();
    if (report.cell->dropped == 0) return;
    report.warnings.push_back(fmt::format(
        "{} more contacts and near misses than the report lists were left out", report.cell->dropped));
}

}  // namespace gsim::simulation
