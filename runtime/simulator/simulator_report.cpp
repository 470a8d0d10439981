// Report of a run at its end.

#include <utility>

#include <fmt/format.h>

#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

Report Simulator::finish(std::string program) {
    if (status_ == RunStatus::completed) wait_for_groups(last_location_);
    motion_->end_program();
    if (motion_->error()) report_plan_error(motion_->last_error(), last_location_);
    if (motion_->time_s() > limits_.max_time_s) stop_for_time(last_location_);  // including pending moves
    if (zones_.hit()) fail_in_zone();
    add_range_excess_steps();
    if (!alarm_ && process_on_) process_.end_program(next_id_, last_location_);
    Report report;
    if (!overrides_.empty()) report.overrides.emplace();
    recorder_.finish(report);
    report.findings = process_.release();
    report.blends = path_deviation_monitor_.blends();
    report.blends.measured = !is_sampled();
    if (machine_.process) report.process = machine::name(machine_.process->kind);
    if (!is_sampled()) report.controller = machine_.controller.model;
    report.program = std::move(program);
    report.status = status_;
    report.alarm = alarm_;
    report.violations = release_violations();
    if (report.status == RunStatus::completed && report.violations.count > 0)
        report.status = RunStatus::violations;
    report.blocks = blocks_;
    report.words_s = words_s_;
    report.passes = passes_;
    if (report.overrides) report.overrides->changes = std::move(overrides_);
    report.events = events_.release();
    report.warnings = std::move(warnings_);
    if (const auto warning = centripetal_monitor_.warning(files_)) report.warnings.push_back(*warning);
    if (const auto warning = early_braking_monitor_.warning(files_)) report.warnings.push_back(*warning);
    if (events_.dropped() > 0) {
        report.warnings.push_back(
            fmt::format("{} more events than the report lists were left out", events_.dropped()));
    }
    add_cell_findings(report);
    add_efforts(report);
    add_interval(report);
    add_following(report);
    report.files = files_;
    return report;
}

}  // namespace gsim::simulation
