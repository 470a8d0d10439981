#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "controller/module/rcs_host.h"
#include "machine/model/machine.h"
#include "motion/planner/override_schedule.h"
#include "motion/planner/planner_setup.h"
#include "runtime/monitors/path_deviation_monitor.h"
#include "runtime/monitors/path_sinks.h"
#include "runtime/monitors/zone_monitor.h"
#include "runtime/motion_sources/motion_observer.h"
#include "runtime/motion_sources/motion_source.h"
#include "runtime/report/recorder.h"

namespace gsim::simulation {

/// Motion of a machine: its controller, and the receivers of the controller's segments and paths. Segments
/// pass the zones and then enter the recorder, which feeds the outputs of the run.
class MachineMotion {
  public:
    /// Makes the motion of a machine that is at its home, with `module` or our own planner as the controller.
    /// `machine` must outlive this; steps of a module end at `max_time_s`. Throws std::invalid_argument if
    /// the planner does not support the machine.
    MachineMotion(const machine::Machine& machine, std::optional<rrs::RcsModule> module, double max_time_s);
    MachineMotion(const MachineMotion&) = delete;
    MachineMotion& operator=(const MachineMotion&) = delete;

    MotionSource& source() { return *source_; }
    const MotionSource& source() const { return *source_; }
    const motion::PlannerSetup& setup() const { return setup_; }
    Recorder& recorder() { return recorder_; }
    const Recorder& recorder() const { return recorder_; }
    ZoneMonitor& zones() { return zones_; }
    const ZoneMonitor& zones() const { return zones_; }
    PathDeviationMonitor& path_deviation() { return path_deviation_monitor_; }
    const PathDeviationMonitor& path_deviation() const { return path_deviation_monitor_; }

    /// Adds a receiver of the programmed paths, which must outlive this, before the first move.
    void add_path_sink(motion::PathSink& sink) { path_sinks_.add(sink); }
    /// Sets an observer of the requests to the controller, which must outlive this, before the first move.
    void observe(MotionObserver& observer);
    /// Sets the overrides that the operator selects in the course of the run, before the first move. Returns
    /// false if the controller is a module, which has overrides of its own.
    bool set_overrides(const motion::OverrideSchedule& overrides);
    /// Returns the changes of the overrides in the course of the run.
    const std::vector<motion::OverrideChange>& overrides() const { return overrides_; }
    /// Sets the source of axis accelerations for each move, before the first one. Returns false if the
    /// controller does not accept it; then the machine's accelerations continue to apply.
    bool set_move_limits(std::shared_ptr<const motion::MoveLimits> limits);

  private:
    std::unique_ptr<MotionSource> make_source(std::optional<rrs::RcsModule> module, double max_time_s);

    const machine::Machine& machine_;
    Recorder recorder_;
    ZoneMonitor zones_;
    motion::PlannerSetup setup_;
    PathDeviationMonitor path_deviation_monitor_;
    PathSinks path_sinks_;
    std::unique_ptr<MotionSource> source_;
    std::vector<motion::OverrideChange> overrides_;
};

}  // namespace gsim::simulation
