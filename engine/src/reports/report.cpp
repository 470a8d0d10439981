#include "engine/report.h"

#include <algorithm>
#include <utility>

#include "engine/src/conversions.h"
#include "runtime/report/report.h"
#include "runtime/report/report_diagnostics.h"
#include "runtime/report/robots_report.h"

namespace gsim::engine {

/// Exactly one of both is set.
struct Report::Full {
    std::optional<simulation::Report> one = {};
    std::optional<simulation::RobotsReport> robots = {};
};

namespace {

SourceLocation source_location(const simulation::Report& report, const simulation::SourceLocation& location) {
    return {.file = location.file < report.source.files.size() ? report.source.files[location.file]
                                                               : std::string(),
            .line = location.line};
}

Alarm to_alarm(const simulation::Report& report) {
    const simulation::Alarm& entry = *report.alarm;
    Alarm alarm{.code = std::string(text::diagnostic_code(entry.kind)),
                .message = entry.message,
                .location = source_location(report, entry.location),
                .axis = entry.axis,
                .value = entry.value,
                .limit = entry.limit};
    for (const simulation::OpenCall& call : entry.calls)
        alarm.calls.push_back({call.program, source_location(report, call.location)});
    return alarm;
}

Violation to_violation(const simulation::Report& report, const simulation::Violation& entry) {
    return {.t_s = entry.t_s,
            .location = source_location(report, entry.location),
            .message = entry.message,
            .zone = entry.zone,
            .axis = entry.axis,
            .rotary = entry.rotary,
            .value = entry.value,
            .limit = entry.limit};
}

void copy_lists(const simulation::Report& from, Report& to) {
    for (const simulation::AxisBounds& axis : from.bounds)
        to.ranges.push_back({axis.letter, axis.rotary, axis.min, axis.max, axis.limit_min, axis.limit_max});
    for (const simulation::Violation& violation : from.violations.list)
        to.violations.push_back(to_violation(from, violation));
    if (from.cell) {
        for (const simulation::Collision& touch : from.cell->collisions) {
            to.collisions.push_back({touch.t_s, source_location(from, touch.location), touch.first,
                                     touch.second, touch.point_mm});
        }
    }
    for (const simulation::Event& event : from.events)
        to.events.push_back({event.t_s, source_location(from, event.location), event.kind, event.detail});
    for (const text::Diagnostic& entry : simulation::report_diagnostics(from))
        to.diagnostics.push_back(to_diagnostic(entry));
}

Report to_report_values(const simulation::Report& from) {
    Report to;
    to.program = from.source.program;
    to.machine = from.source.machine;
    to.status = static_cast<RunStatus>(from.status);
    if (from.alarm) to.alarm = to_alarm(from);
    to.cycle_time_s = from.cycle_time_s;
    if (from.times.interval)
        to.cycle_time_95 = Report::Interval{from.times.interval->min_s, from.times.interval->max_s};
    to.times.rapid_s = from.times.rapid_s;
    to.times.feed_s = from.times.feed_s;
    to.times.dwell_s = from.times.dwell_s;
    to.distances.rapid_mm = from.distances.rapid_mm;
    to.distances.feed_mm = from.distances.feed_mm;
    to.distances.process_on_mm = from.distances.process_on_mm;
    to.counts.blocks = from.counts.blocks;
    to.counts.moves = from.counts.moves;
    to.violation_count = from.violations.count;
    to.process_findings = from.findings.count;
    to.warnings = from.messages.warnings;
    copy_lists(from, to);
    return to;
}

}  // namespace

Report make_report(simulation::Report report) {
    Report result = to_report_values(report);
    result.full = std::make_shared<const Report::Full>(Report::Full{.one = std::move(report)});
    return result;
}

Report make_report(simulation::RobotsReport report) {
    Report result = to_report_values(report.full);
    for (const simulation::RobotReport& robot : report.robots) {
        result.robots.push_back(make_report(simulation::Report(robot.report)));
        result.robots.back().robot = robot.name;
    }
    result.full = std::make_shared<const Report::Full>(Report::Full{.robots = std::move(report)});
    return result;
}

std::string_view name(RunStatus status) {
    return simulation::name(static_cast<simulation::RunStatus>(status));
}

bool Report::is_clean() const {
    const bool touches =
        !collisions.empty() ||
        std::any_of(robots.begin(), robots.end(), [](const Report& r) { return !r.collisions.empty(); });
    return status == RunStatus::completed && !touches;
}

std::string Report::json() const {
    if (!full) return "{}";
    return full->one ? to_json(*full->one) : to_json(*full->robots);
}

std::string Report::text() const {
    if (!full) return {};
    return full->one ? to_text(*full->one) : to_text(*full->robots);
}

Report Report::with(const Diagnostic& diagnostic) const {
    if (!full) return *this;
    if (full->one) {
        simulation::Report one = *full->one;
        one.messages.diagnostics.push_back(to_text_diagnostic(diagnostic));
        return make_report(std::move(one));
    }
    simulation::RobotsReport all = *full->robots;
    all.full.messages.diagnostics.push_back(to_text_diagnostic(diagnostic));
    return make_report(std::move(all));
}

}  // namespace gsim::engine
