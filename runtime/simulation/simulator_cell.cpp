// The cell in which the machine of a Simulator stands.

#include <fmt/format.h>

#include "runtime/simulation/simulator.h"

namespace gsim::simulation {

void Simulator::set_cell(CellWatch& cell) {
    cell_ = &cell;
    recorder_.add_output(cell);
}

rrs::Status Simulator::get_cell_frame(std::string_view name, rrs::CartPos& frame) {
    return cell_ != nullptr ? cell_->get_frame(name, frame) : controller().GetCellFrame(name, frame);
}

rrs::Status Simulator::modify_cell_frame(std::string_view name, const rrs::CartPos& frame) {
    if (cell_ == nullptr) return controller().ModifyCellFrame(name, frame);
    wait();
    return cell_->move_frame(name, frame);
}

void Simulator::add_cell_findings(Report& report) {
    if (cell_ == nullptr) return;
    report.cell = cell_->release();
    if (report.cell->dropped == 0) return;
    report.warnings.push_back(fmt::format(
        "{} more contacts and near misses than the report lists were left out", report.cell->dropped));
}

}  // namespace gsim::simulation
