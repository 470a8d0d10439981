#include "runtime/report/robots_report.h"

#include <algorithm>

#include <fmt/format.h>

namespace gsim::simulation {

RobotsReport robots_report(Report whole, std::vector<RobotReport> robots) {
    for (const RobotReport& robot : robots) {
        whole.cycle_time_s = std::max(whole.cycle_time_s, robot.report.cycle_time_s);
        whole.blocks += robot.report.blocks;
        whole.moves += robot.report.moves;
        whole.violations.count += robot.report.violations.count;
        if (whole.alarm || !robot.report.alarm) continue;
        whole.status = robot.report.status;
        whole.alarm = robot.report.alarm;
    }
    if (whole.status == RunStatus::completed && whole.violations.count > 0)
        whole.status = RunStatus::violations;
    for (const ProcessSummary& process : whole.processes) {
        if (!process.background) whole.cycle_time_s = std::max(whole.cycle_time_s, process.end_s);
    }
    if (!robots.empty()) whole.files = robots.front().report.files;
    return {std::move(whole), std::move(robots)};
}

std::string to_text(const RobotsReport& report) {
    std::string text = to_text(report.whole);
    for (const RobotReport& robot : report.robots) {
        text += fmt::format("\n--- robot {}, idle for {:.3f} s\n{}", robot.name, robot.idle_s,
                            to_text(robot.report));
    }
    return text;
}

}  // namespace gsim::simulation
