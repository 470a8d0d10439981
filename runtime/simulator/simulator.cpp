#include "runtime/simulator/simulator.h"

#include <utility>

#include <fmt/format.h>

namespace gsim::simulation {

Simulator::Simulator(machine::Machine machine, RunLimits limits, std::optional<rrs::RcsModule> module)
    : machine_(std::move(machine)),
      motion_(machine_, std::move(module), limits.max_time_s),
      position_(machine_, motion_.setup()),
      clock_(motion_, position_, notifier_),
      program_(machine_, motion_, position_, notifier_, warnings_),
      outcome_(machine_, limits, motion_, program_.calls(), program_.ids()),
      events_(motion_, position_, program_.ids(), notifier_),
      violations_(machine_, motion_, program_, outcome_, events_.log()),
      monitors_(machine_, motion_, program_.tool().tcps_mm(), warnings_),
      tcp_control_(motion_, clock_, position_, program_.tool(), outcome_, notifier_),
      cell_(motion_, clock_, program_, tcp_control_, notifier_),
      acceptance_(motion_, position_, program_.settings(), outcome_, violations_, warnings_, notifier_),
      dwells_(machine_, motion_, clock_, position_, program_, acceptance_, notifier_),
      groups_(machine_, motion_, clock_, position_, program_.ids(), outcome_, violations_.ranges(), dwells_,
              events_.log(), notifier_),
      poses_(machine_, motion_, position_, program_, groups_, warnings_),
      moves_(machine_, motion_, position_, program_, outcome_, violations_.ranges(), acceptance_, groups_,
             poses_, warnings_, notifier_),
      is_probing_(motion_, clock_, position_, program_, cell_, outcome_, violations_.ranges(), acceptance_,
                  groups_, moves_.feeds(), warnings_),
      services_(motion_, clock_, position_, program_, outcome_, notifier_) {
    start();
}

void Simulator::start() {
    const motion::PlanResult started = motion_.source().start_at(position_.to_joints(position_.axes()));
    if (!started) outcome_.fail(started.error(), {});
    monitors_.start_interval();
    program_.ramps().warn_about_jerk();
}

void Simulator::set_observer(ProgramObserver& observer) {
    notifier_.set_observer(observer);
    if (const auto& offset = program_.work_offsets().selected()) observer.work_offset(*offset);
}

void Simulator::end_motion() {
    const SourceLocation& last_location = program_.ids().last_location();
    if (outcome_.status() == RunStatus::completed) groups_.wait(last_location);
    MotionSource& source = motion_.source();
    source.end_program();
    if (source.error()) outcome_.fail(source.last_error(), last_location);
    if (outcome_.is_past_max_time()) outcome_.stop_for_time(last_location);  // including pending moves
    violations_.end_run();
    if (!outcome_.alarm()) program_.process().end_run();
}

Report Simulator::finish(std::string program) {
    end_motion();
    const bool is_sampled = motion_.source().is_sampled();
    Report report;
    if (!motion_.overrides().empty()) report.overrides.emplace();
    motion_.recorder().finish(report);
    report.findings = program_.process().release();
    report.blends = motion_.path_deviation().blends();
    report.blends.measured = !is_sampled;
    if (machine_.process) report.source.process = machine::name(machine_.process->kind);
    if (!is_sampled) report.source.controller = machine_.controller.model;
    report.source.program = std::move(program);
    report.status = outcome_.status();
    report.alarm = outcome_.alarm();
    report.violations = violations_.release();
    if (report.status == RunStatus::completed && report.violations.count > 0)
        report.status = RunStatus::violations;
    report.counts.blocks = outcome_.blocks();
    report.times.words_s = dwells_.words_s();
    report.passes = program_.calls().passes();
    if (report.overrides) report.overrides->changes = motion_.overrides();
    report.events = events_.log().release();
    report.messages.warnings = warnings_.release();
    monitors_.add_warnings(program_.files().names(), report);
    if (events_.log().dropped() > 0) {
        report.messages.warnings.push_back(
            fmt::format("{} more events are not listed in the report", events_.log().dropped()));
    }
    cell_.add_findings(report);
    monitors_.add_results(outcome_.status(), program_.calls().names(), report);
    report.source.files = program_.files().names();
    return report;
}

}  // namespace gsim::simulation
