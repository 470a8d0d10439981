// Uncertainty of the time of a run.

#include <fmt/format.h>

#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

void Simulator::start_interval_monitor() {
    if (machine_.calibration) observe_motion(interval_monitor_.emplace(machine_));
}

void Simulator::add_interval(Report& report) const {
    if (!interval_monitor_ || status_ != RunStatus::completed) return;
    report.interval = interval_monitor_->interval(report.cycle_time_s);
    if (report.interval || report.cycle_time_s <= 0) return;
    report.warnings.push_back(
        fmt::format("the machine's figures are calibrated, but the cycle time comes without an interval: {}",
                    interval_monitor_->error()));
}

}  // namespace gsim::simulation
