#include <cmath>
#include <utility>

#include "base/text/diagnostic_json.h"
#include "base/text/file_format.h"
#include "runtime/report/json_values.h"
#include "runtime/report/report_diagnostics.h"
#include "runtime/report/report_efforts.h"
#include "runtime/report/report_following.h"
#include "runtime/report/robots_report.h"

namespace gsim::simulation {

namespace {

Json calls(const Report& report, const std::vector<OpenCall>& open) {
    Json list = Json::array();
    for (const OpenCall& call : open) {
        list.push_back({{"program", call.program},
                        {"file", file(report, call.location)},
                        {"line", line(call.location)}});
    }
    return list;
}

Json alarm(const Report& report) {
    if (!report.alarm) return nullptr;
    const Alarm& alarm = *report.alarm;
    return {{"code", text::diagnostic_code(alarm.kind)},
            {"message", alarm.message},
            {"file", file(report, alarm.location)},
            {"line", line(alarm.location)},
            {"axis", alarm.axis != 0 ? letter(alarm.axis) : Json(nullptr)},
            {"value", number(alarm.value)},
            {"limit", number(alarm.limit)},
            {"calls", calls(report, alarm.calls)}};
}

Json violations(const Report& report) {
    Json list = Json::array();
    for (const Violation& violation : report.violations.list) {
        list.push_back({{"t_s", number(violation.t_s)},
                        {"file", file(report, violation.location)},
                        {"line", line(violation.location)},
                        {"axis", letter(violation.axis)},
                        {"unit", violation.rotary ? "deg" : "mm"},
                        {"value", number(violation.value)},
                        {"limit", number(violation.limit)},
                        {"amount", number(violation.amount())},
                        {"zone", violation.zone.empty() ? Json(nullptr) : Json(violation.zone)},
                        {"offset", violation.offset.empty() ? Json(nullptr) : Json(violation.offset)},
                        {"message", violation.message},
                        {"calls", calls(report, violation.calls)}});
    }
    return list;
}

Json findings(const Report& report) {
    Json list = Json::array();
    for (const ProcessFinding& finding : report.findings.list) {
        list.push_back({{"t_s", number(finding.t_s)},
                        {"file", file(report, finding.location)},
                        {"line", line(finding.location)},
                        {"code", text::diagnostic_code(finding.kind)},
                        {"message", finding.message}});
    }
    return list;
}

Json suggested_fix(const Violations& violations) {
    Json list = Json::array();
    for (const OffsetShift& shift : violations.suggested_fix) {
        list.push_back(
            {{"offset", shift.offset}, {"axis", letter(shift.axis)}, {"shift_mm", number(shift.shift_mm)}});
    }
    return list;
}

Json deviation(const Report& report, const Deviation& deviation) {
    const bool any = deviation.deviation_mm > 0;
    return {{"max_deviation_mm", number(deviation.deviation_mm)},
            {"file", any ? file(report, deviation.location) : Json(nullptr)},
            {"line", any ? line(deviation.location) : Json(nullptr)}};
}

Json blends(const Report& report) {
    if (!report.blends.measured) return nullptr;
    Json blends{{"count", report.blends.count}};
    blends.update(deviation(report, report.blends.max()));
    blends["feed"] = deviation(report, report.blends.feed);
    blends["rapid"] = deviation(report, report.blends.rapid);
    return blends;
}

Json bounds(const Report& report) {
    Json bounds = Json::object();
    for (const AxisBounds& axis : report.bounds) {
        bounds[std::string(1, axis.letter)] = {{"min", number(axis.min)},
                                               {"max", number(axis.max)},
                                               {"limit_min", number(axis.limit_min)},
                                               {"limit_max", number(axis.limit_max)}};
    }
    return bounds;
}

Json events(const Report& report) {
    Json events = Json::array();
    for (const Event& event : report.events) {
        Json entry = {{"t_s", number(event.t_s)},
                      {"file", file(report, event.location)},
                      {"line", line(event.location)},
                      {"kind", event.kind}};
        if (!event.detail.empty()) entry["detail"] = event.detail;
        events.push_back(std::move(entry));
    }
    return events;
}

Json slowest(const Report& report) {
    Json blocks = Json::array();
    for (const SlowBlock& block : report.slowest) {
        blocks.push_back({{"file", file(report, block.location)},
                          {"line", line(block.location)},
                          {"kind", std::string(name(block.kind))},
                          {"duration_s", number(block.duration_s)},
                          {"length_mm", number(block.length_mm)},
                          {"limited_by", block.limited_by.empty() ? Json(nullptr) : Json(block.limited_by)}});
    }
    return blocks;
}

Json time_by_limit(const Explanation& explanation) {
    Json times = Json::array();
    for (const LimitTime& limit : explanation.time_by_limit) {
        times.push_back({{"limited_by", limit.limited_by}, {"time_s", number(limit.time_s)}});
    }
    return times;
}

Json point(const std::array<double, 3>& point_mm) {
    return Json::array({number(point_mm[0]), number(point_mm[1]), number(point_mm[2])});
}

Json checked_bodies(const CheckedBodies& bodies) {
    Json json{{"of_machine", bodies.machine_shapes}, {"jets", bodies.jets},
              {"objects", bodies.objects},           {"pairs", bodies.pairs},
              {"may_touch", bodies.allowed_pairs},   {"replaced", bodies.replaced}};
    if (bodies.robot_pairs > 0) json["with_robots"] = bodies.robot_pairs;
    return json;
}

Json collisions(const Report& report) {
    Json list = Json::array();
    for (const Collision& collision : report.cell->collisions) {
        list.push_back({{"t_s", number(collision.t_s)},
                        {"file", file(report, collision.location)},
                        {"line", line(collision.location)},
                        {"pair", Json::array({collision.first, collision.second})},
                        {"point_mm", point(collision.point_mm)},
                        {"kind", collision.penetrating ? "penetrating" : "touching"}});
    }
    return list;
}

Json clearances(const Report& report) {
    Json list = Json::array();
    for (const BlockClearance& block : report.cell->clearances) {
        list.push_back({{"file", file(report, block.location)},
                        {"line", line(block.location)},
                        {"clearance_mm", number(block.clearance_mm)},
                        {"pair", Json::array({block.first, block.second})},
                        {"point_mm", point(block.point_mm)}});
    }
    return list;
}

Json processes(const std::vector<ProcessSummary>& list) {
    Json processes = Json::array();
    for (const ProcessSummary& process : list) {
        processes.push_back({{"name", process.name},
                             {"robot", process.robot.empty() ? Json(nullptr) : Json(process.robot)},
                             {"state", process.state},
                             {"start_s", number(process.start_s)},
                             {"end_s", number(process.end_s)},
                             {"idle_s", number(process.idle_s)}});
    }
    return processes;
}

Json signals(const Report& report) {
    Json signals = Json::array();
    for (const SignalChange& change : report.concurrency.signals) {
        signals.push_back({{"t_s", number(change.t_s)},
                           {"file", file(report, change.location)},
                           {"line", line(change.location)},
                           {"process", change.process},
                           {"signal", change.signal},
                           {"value", change.value}});
    }
    return signals;
}

Json zone_uses(const Report& report) {
    Json uses = Json::array();
    for (const ZoneUse& use : report.concurrency.zone_uses) {
        uses.push_back({{"zone", use.zone},
                        {"process", use.process},
                        {"file", file(report, use.location)},
                        {"line", line(use.location)},
                        {"requested_s", number(use.requested_s)},
                        {"from_s", use.from_s ? number(*use.from_s) : Json(nullptr)},
                        {"to_s", use.to_s ? number(*use.to_s) : Json(nullptr)}});
    }
    return uses;
}

Json passes(const Report& report) {
    return {{"count", report.passes->count},
            {"file", file(report, report.passes->location)},
            {"line", line(report.passes->location)},
            {"to_block", report.passes->to_block ? Json(*report.passes->to_block) : Json(nullptr)}};
}

/// Avoids the rounding of shares.
double percent(double share) {
    return std::round(share * 1e10) / 1e8;
}

Json overrides(const OverrideReport& overrides) {
    Json changes = Json::array();
    for (const motion::OverrideChange& change : overrides.changes) {
        changes.push_back({{"at_s", number(change.at_s)},
                           {"feed_percent", number(percent(change.to.feed))},
                           {"rapid_percent", number(percent(change.to.rapid))},
                           {"spindle_percent", number(percent(change.to.spindle))}});
    }
    return {{"changes", std::move(changes)},
            {"feed_locked_s", number(overrides.feed_locked_s)},
            {"rapid_locked_s", number(overrides.rapid_locked_s)},
            {"spindle_locked_s", number(overrides.spindle_locked_s)}};
}

// Adds `words_s` if words take time.
Json times(const Report& report) {
    Json json = {{"rapid_s", number(report.times.rapid_s)},
                 {"feed_s", number(report.times.feed_s)},
                 {"dwell_s", number(report.times.dwell_s)}};
    if (report.times.words_s > 0) json["words_s"] = number(report.times.words_s);
    return json;
}

Json object(const Report& report) {
    Json json = {
        {"program", report.source.program},
        {"machine", report.source.machine},
        {"controller", report.source.controller.empty() ? Json(nullptr) : Json(report.source.controller)},
        {"status", std::string(name(report.status))},
        {"alarm", alarm(report)},
        {"violations", violations(report)},
        {"violation_count", report.violations.count},
        {"suggested_fix", suggested_fix(report.violations)},
        {"cycle_time_s", number(report.cycle_time_s)},
        {"valid_until_s", number(report.violations.valid_until_s())},
        {"time", times(report)},
        {"process", report.source.process},
        {"length",
         {{"rapid_mm", number(report.distances.rapid_mm)},
          {"feed_mm", number(report.distances.feed_mm)},
          {"process_on_mm", number(report.distances.process_on_mm)}}},
        {"blocks", report.counts.blocks},
        {"moves", report.counts.moves},
        {"blends", blends(report)},
        {"bounds", bounds(report)},
        {"events", events(report)},
        {"warnings", report.messages.warnings},
        {"diagnostics", text::to_json(report_diagnostics(report))},
        {"findings", findings(report)},
        {"slowest", slowest(report)},
    };
    if (report.passes) json["passes"] = passes(report);
    if (report.overrides) json["overrides"] = overrides(*report.overrides);
    if (report.explanation) {
        json["time_by_limit"] = time_by_limit(*report.explanation);
        json["lower_bound_s"] = number(report.explanation->lower_bound_s);
    }
    if (report.times.interval)
        json["cycle_time_95_s"] = {number(report.times.interval->min_s),
                                   number(report.times.interval->max_s)};
    if (report.drives.efforts) json["efforts"] = efforts_json(report);
    if (report.drives.following) json["following"] = following_json(report);
    if (report.cell) {
        json["cell"] = {{"name", report.cell->name},
                        {"clearance_mm", number(report.cell->clearance_mm)},
                        {"checked", checked_bodies(report.cell->checked_bodies)}};
        json["collisions"] = collisions(report);
        json["clearances"] = clearances(report);
    }
    if (!report.concurrency.processes.empty()) {
        json["processes"] = processes(report.concurrency.processes);
        json["signals"] = signals(report);
    }
    return json;
}

std::string text(const Json& report) {
    Json json = {{"format", text::kFileFormat}};
    json.update(report);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace

std::string to_json(const Report& report) {
    return text(object(report));
}

std::string to_json(const RobotsReport& report) {
    const Report& full = report.full;
    Json json = {{"program", full.source.program},
                 {"status", std::string(name(full.status))},
                 {"alarm", alarm(full)},
                 {"violation_count", full.violations.count},
                 {"cycle_time_s", number(full.cycle_time_s)},
                 {"processes", processes(full.concurrency.processes)},
                 {"signals", signals(full)},
                 {"zones", zone_uses(full)},
                 {"warnings", full.messages.warnings}};
    Json robots = Json::array();
    for (const RobotReport& robot : report.robots) {
        Json entry = {{"name", robot.name}, {"idle_s", number(robot.idle_s)}};
        entry.update(object(robot.report));
        robots.push_back(std::move(entry));
    }
    json["robots"] = std::move(robots);
    return text(json);
}

}  // namespace gsim::simulation
