#include "engine/report.h"

#include <algorithm>
#include <utility>

#include "engine/src/values.h"
#include "runtime/report/report.h"
#include "runtime/report/report_diagnostics.h"
#include "runtime/report/robots_report.h"

namespace gsim::engine {

/// Exactly one of both is set.
struct Report::Whole {
    std::optional<simulation::Report> one = {};
    std::optional<simulation::RobotsReport> robots = {};
};

namespace {

Place place_of(const simulation::Report& report, const simulation::Place& place) {
    return {.file = place.file < report.files.size() ? report.files[place.file] : std::string(),
            .line = place.line};
}

Alarm alarm_of(const simulation::Report& report) {
    const simulation::Alarm& told = *report.alarm;
    Alarm alarm{.code = std::string(text::code_of(told.kind)),
                .message = told.message,
                .place = place_of(report, told.place),
                .axis = told.axis,
                .value = told.value,
                .limit = told.limit};
    for (const simulation::OpenCall& call : told.calls)
        alarm.calls.push_back({call.program, place_of(report, call.place)});
    return alarm;
}

Violation violation_of(const simulation::Report& report, const simulation::Violation& told) {
    return {.t_s = told.t_s,
            .place = place_of(report, told.place),
            .message = told.message,
            .zone = told.zone,
            .axis = told.axis,
            .rotary = told.rotary,
            .value = told.value,
            .limit = told.limit};
}

void take_lists(const simulation::Report& from, Report& to) {
    for (const simulation::AxisBounds& axis : from.bounds)
        to.ranges.push_back({axis.letter, axis.rotary, axis.min, axis.max, axis.limit_min, axis.limit_max});
    for (const simulation::Violation& violation : from.violations.list)
        to.violations.push_back(violation_of(from, violation));
    if (from.cell) {
        for (const simulation::Collision& touch : from.cell->collisions) {
            to.collisions.push_back(
                {touch.t_s, place_of(from, touch.place), touch.first, touch.second, touch.point_mm});
        }
    }
    for (const simulation::Event& event : from.events)
        to.events.push_back({event.t_s, place_of(from, event.place), event.kind, event.detail});
    for (const text::Diagnostic& told : simulation::diagnostics_of(from))
        to.diagnostics.push_back(diagnostic_of(told));
}

Report figures_of(const simulation::Report& from) {
    Report to;
    to.program = from.program;
    to.machine = from.machine;
    to.status = static_cast<RunStatus>(from.status);
    if (from.alarm) to.alarm = alarm_of(from);
    to.cycle_time_s = from.cycle_time_s;
    if (from.interval) to.cycle_time_95 = Report::Interval{from.interval->least_s, from.interval->most_s};
    to.rapid_s = from.rapid_s;
    to.feed_s = from.feed_s;
    to.dwell_s = from.dwell_s;
    to.rapid_mm = from.rapid_mm;
    to.feed_mm = from.feed_mm;
    to.jet_on_mm = from.jet_on_mm;
    to.blocks = from.blocks;
    to.moves = from.moves;
    to.violation_count = from.violations.count;
    to.process_findings = from.findings.count;
    to.warnings = from.warnings;
    take_lists(from, to);
    return to;
}

}  // namespace

Report report_of(simulation::Report report) {
    Report made = figures_of(report);
    made.whole = std::make_shared<const Report::Whole>(Report::Whole{.one = std::move(report)});
    return made;
}

Report report_of(simulation::RobotsReport report) {
    Report made = figures_of(report.whole);
    for (const simulation::RobotReport& robot : report.robots) {
        made.robots.push_back(report_of(simulation::Report(robot.report)));
        made.robots.back().robot = robot.name;
    }
    made.whole = std::make_shared<const Report::Whole>(Report::Whole{.robots = std::move(report)});
    return made;
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
    if (!whole) return "{}";
    return whole->one ? to_json(*whole->one) : to_json(*whole->robots);
}

std::string Report::text() const {
    if (!whole) return {};
    return whole->one ? to_text(*whole->one) : to_text(*whole->robots);
}

Report Report::with(const Diagnostic& diagnostic) const {
    if (!whole) return *this;
    if (whole->one) {
        simulation::Report one = *whole->one;
        one.diagnostics.push_back(inner_diagnostic(diagnostic));
        return report_of(std::move(one));
    }
    simulation::RobotsReport all = *whole->robots;
    all.whole.diagnostics.push_back(inner_diagnostic(diagnostic));
    return report_of(std::move(all));
}

}  // namespace gsim::engine
