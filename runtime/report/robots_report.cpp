#include "runtime/report/robots_report.h"

#include <algorithm>

#include <fmt/format.h>

namespace gsim::simulation {

RobotsReport robots_report(Report full, std::vector<RobotReport> robots) {
    for (const RobotReport& robot : robots) {
        full.cycle_time_s = std::max(full.cycle_time_s, robot.report.cycle_time_s);
        full.counts.blocks += robot.report.counts.blocks;
        full.counts.moves += robot.report.counts.moves;
        full.violations.count += robot.report.violations.count;
        if (full.alarm || !robot.report.alarm) continue;
        full.status = robot.report.status;
        full.alarm = robot.report.alarm;
    }
    if (full.status == RunStatus::completed && full.violations.count > 0) full.status = RunStatus::violations;
    for (const ProcessSummary& process : full.concurrency.processes) {
        if (!process.background) full.cycle_time_s = std::max(full.cycle_time_s, process.end_s);
    }
    if (!robots.empty()) full.source.files = robots.front().report.source.files;
    return {std::move(full), std::move(robots)};
}

std::string to_text(const RobotsReport& report) {
    std::string text = to_text(report.full);
    for (const RobotReport& robot : report.robots) {
        text += fmt::format("\n--- robot {}, idle for {:.3f} s\n{}", robot.name, robot.idle_s,
                            to_text(robot.report));
    }
    return text;
}

}  // namespace gsim::simulation
