#pragma once

#include <cstddef>
#include <optional>

#include "runtime/monitors/multi_robot_monitor.h"
#include "runtime/script/processes/process_robots.h"
#include "runtime/script/processes/process_table.h"

namespace gsim::script {

/// Notifies the monitors of what is known about the motion of other processes: the time up to which conveyors
/// and robots have all their motion, and the owners of robots and zones.
class KnownMotion {
  public:
    /// `table` and `robots` must outlive this.
    KnownMotion(const ProcessTable& table, const ProcessRobots& robots) : table_(table), robots_(robots) {}

    /// Sets the monitor of several robots, which must outlive this.
    void set_multi_robot_monitor(simulation::MultiRobotMonitor& monitor) { multi_robot_monitor_ = &monitor; }
    /// Notifies the monitors of the time up to which the motion is known now.
    void update() const;
    /// Notifies the monitor of several robots that from `time_s` on the process has the zone; nullopt: none.
    void on_zone_holder(std::size_t zone, double time_s,
                        const std::optional<process::ProcessId>& holder) const;
    /// Notifies the same monitor that the running process has the robot from its time on.
    void on_robot_owner(const RobotController& controller) const;

  private:
    void update_conveyors() const;

    const ProcessTable& table_;
    const ProcessRobots& robots_;
    simulation::MultiRobotMonitor* multi_robot_monitor_ = nullptr;
};

}  // namespace gsim::script
