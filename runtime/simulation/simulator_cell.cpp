// The cell in which the machine of a Simulator stands.

#include <fmt/format.h>

#include "runtime/simulation/simulator.h"

namespace gsim::simulation {

void Simulator::set_cell(CellWatch& cell) {
    cell_ = &cell;
    controller_has_cell_ = motion_->set_cell(cell);
    recorder_.add_output(cell);
}

rrs::Status Simulator::get_cell_frame(std::string_view name, rrs::CartPos& frame) {
    if (cell_ == nullptr || controller_has_cell_) return controller().GetCellFrame(name, frame);
    const auto found = cell_->frame(name, motion_->time_s());
    if (!found) return found.error().status;
    frame = *found;
    return rrs::Status::RRS_SUCCESS;
}

rrs::Status Simulator::modify_cell_frame(std::string_view name, const rrs::CartPos& frame) {
    if (cell_ == nullptr || controller_has_cell_) return controller().ModifyCellFrame(name, frame);
    wait();
    const motion::Planned moved = cell_->move_frame(name, frame, motion_->time_s());
    return moved ? rrs::Status::RRS_SUCCESS : moved.error().status;
}

void Simulator::set_conveyor(std::string_view name, const Eigen::Vector3d& at_mm,
                             const Eigen::Vector3d& velocity_mm_s, double time_s) {
    if (cell_ == nullptr) return;
    cell::Drift drift{.from_s = time_s, .velocity_mm_s = velocity_mm_s};
    drift.pose.translation() = at_mm;
    cell_->set_conveyor(name, drift);
}

void Simulator::add_cell_findings(Report& report) {
    if (cell_ == nullptr) return;
    report.cell = cell_->release();
    if (report.cell->dropped == 0) return;
    report.warnings.push_back(fmt::format(
        "{} more contacts and near misses than the report lists were left out", report.cell->dropped));
}

}  // namespace gsim::simulation
