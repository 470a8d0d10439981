#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "runtime/processes/conveyor.h"
#include "runtime/script/processes/process_robots.h"
#include "runtime/script/processes/process_signals.h"
#include "runtime/script/processes/process_table.h"

namespace gsim::script {

/// Conveyors of a run: their speeds, and the robots that follow them.
class ProcessConveyors {
  public:
    /// `table`, `robots` and `signals` must outlive this.
    ProcessConveyors(ProcessTable& table, const ProcessRobots& robots, ProcessSignals& signals,
                     std::vector<process::Conveyor> conveyors)
        : table_(table), robots_(robots), signals_(signals), conveyors_(std::move(conveyors)) {}

    /// Returns the conveyor of this name; null if there is none.
    process::Conveyor* find(std::string_view name);
    std::vector<std::string_view> names() const;
    /// Sets the motion of all conveyors from time 0 on in the cells of robots.
    void start() const;
    /// Sets the speed of a belt, from the running process's time on.
    void set_speed(lua_State* state, process::Conveyor& conveyor, double speed_mm_s);
    /// Sets the targets of this robot that follow to be in the frame of a conveyor; null: no conveyor.
    void track(lua_State* state, RobotController& controller, process::Conveyor* conveyor);

  private:
    void set_in_cells(const process::Conveyor& conveyor, double time_s) const;

    ProcessTable& table_;
    const ProcessRobots& robots_;
    ProcessSignals& signals_;
    std::vector<process::Conveyor> conveyors_;
    std::map<const RobotController*, const process::Conveyor*> tracked_conveyors_;
};

}  // namespace gsim::script
