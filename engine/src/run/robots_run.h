#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "base/error.h"
#include "engine/diagnostic.h"
#include "engine/src/run/program_run.h"
#include "engine/src/run/run_inputs.h"
#include "runtime/monitors/multi_robot_monitor.h"
#include "runtime/processes/robots_file.h"
#include "runtime/report/robots_report.h"
#include "runtime/script/engine/engine.h"

namespace gsim::engine {

/// A script that moves several robots.
class RobotsRun {
  public:
    /// All data of one robot for the run; it keeps its address.
    struct Station {
        process::RobotEntry entry;
        std::unique_ptr<simulation::CellMonitor> cell;
        std::unique_ptr<simulation::Simulator> simulator;
        Language language;
        machine::MachineData data;
    };

    /// Reads the file of robots, and the files that it names. The arguments must outlive the run.
    static tl::expected<RobotsRun, Error> open(const ResolvedRequest& found, const RunContext& tools);

    std::vector<Station>& stations() { return stations_; }
    const std::vector<Station>& stations() const { return stations_; }
    const std::string& program() const { return program_; }

    /// Reads the program.
    tl::expected<void, Error> prepare(OpenedScript& opened, ProgressHandler progress);
    /// Runs it. Returns the reports of the robots, in their order, without the additions of outputs.
    std::vector<simulation::RobotReport> run();
    /// Returns the complete report, from the reports of the robots.
    simulation::RobotsReport combined_report(std::vector<simulation::RobotReport> robots) const;

  private:
    RobotsRun(const ResolvedRequest& found, const RunContext& tools) : found_(&found), run_context_(&tools) {}

    tl::expected<Station, Error> make_station(const process::RobotEntry& entry,
                                              const std::vector<std::string>& conveyors) const;
    Result<std::unique_ptr<simulation::CellMonitor>> read_cell(
        const process::RobotEntry& entry, const machine::Machine& machine,
        const std::vector<std::string>& conveyors) const;
    std::vector<script::Robot> robots();
    void monitor_robots();

    const ResolvedRequest* found_;
    const RunContext* run_context_;
    std::vector<Station> stations_;
    std::vector<process::Conveyor> conveyors_;
    std::vector<process::SharedZone> zones_;
    std::string program_;
    std::optional<script::Script> script_;
    std::unique_ptr<simulation::MultiRobotMonitor> monitor_;
    std::unique_ptr<script::Engine> engine_;
};

}  // namespace gsim::engine
