#pragma once

#include <string>
#include <vector>

#include "runtime/report/report.h"

namespace gsim::simulation {

struct RobotReport {
    std::string name;
    double idle_s = 0;  ///< In which it waited for others; counted as dwell, too.
    Report report;
};

/// Result of a run of several robots.
struct RobotsReport {
    /// Program, status, alarm, cycle time, processes and signals of all together; other values are each
    /// robot's.
    Report full;
    std::vector<RobotReport> robots;  ///< In the order of their file.
};

/// Combines the reports: the alarm is that of the first robot that has one; the cycle time is the latest end
/// of a robot or of a process that the run waits for.
RobotsReport robots_report(Report full, std::vector<RobotReport> robots);

std::string to_json(const RobotsReport& report);
std::string to_text(const RobotsReport& report);

}  // namespace gsim::simulation
