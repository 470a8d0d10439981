#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "machine/model/machine.h"
#include "motion/dynamics/dynamics.h"
#include "runtime/monitors/centripetal_monitor.h"
#include "runtime/monitors/confidence_interval_monitor.h"
#include "runtime/monitors/early_braking_monitor.h"
#include "runtime/monitors/effort_monitor.h"
#include "runtime/monitors/following_setup.h"
#include "runtime/report/report.h"
#include "runtime/simulator/machine_motion.h"
#include "runtime/simulator/warnings.h"

namespace gsim::simulation {

class AxisAccelerationTimeMonitor;
class FollowingErrorMonitor;

/// Monitors of the motion itself that every run has: its curvature and braking, and, as the machine file
/// describes them, its motors, its servo loops and the uncertainty of its time.
class RunMonitors {
  public:
    /// Begins before the first move; `tcps_mm` are the TCPs by MoveInfo::tcp. All arguments must outlive
    /// this.
    RunMonitors(const machine::Machine& machine, MachineMotion& motion,
                const std::vector<Eigen::Vector3d>& tcps_mm, Warnings& warnings);
    ~RunMonitors();
    RunMonitors(const RunMonitors&) = delete;
    RunMonitors& operator=(const RunMonitors&) = delete;

    /// Begins to measure the uncertainty of the time, once the machine has its start position.
    void start_interval();
    /// Sets the dynamics, so that the report has the loads of the motors, before the first move.
    void set_dynamics(std::shared_ptr<const dynamics::Dynamics> dynamics);
    /// Returns null if no dynamics were set.
    const dynamics::Dynamics* dynamics() const { return dynamics_.get(); }
    /// Returns the setup of following errors, valid during the lifetime of this; no value if the machine file
    /// does not describe servo loops.
    std::optional<FollowingSetup> following_setup() const;

    /// Adds warnings of the path and the speed to a report, after the end of the run.
    void add_warnings(const std::vector<std::string>& files, Report& report) const;
    /// Adds efforts, the interval of the time and following errors to the report of a run with this status.
    /// `programs` are the names by MoveInfo::program.
    void add_results(RunStatus status, const std::vector<std::string>& programs, Report& report) const;

  private:
    void start_following_error();
    void apply_torque_limits();
    void add_efforts(RunStatus status, const std::vector<std::string>& programs, Report& report) const;
    void add_interval(RunStatus status, Report& report) const;
    void add_following(Report& report) const;

    const machine::Machine& machine_;
    MachineMotion& motion_;
    const std::vector<Eigen::Vector3d>& tcps_mm_;
    Warnings& warnings_;
    CentripetalMonitor centripetal_monitor_;
    EarlyBrakingMonitor early_braking_monitor_;
    std::shared_ptr<const dynamics::Dynamics> dynamics_;
    std::optional<EffortMonitor> efforts_;
    std::unique_ptr<AxisAccelerationTimeMonitor>
        axis_acceleration_time_monitor_;                         ///< Set if torques limit accelerations.
    std::optional<ConfidenceIntervalMonitor> interval_monitor_;  ///< For a calibrated machine.
    std::unique_ptr<FollowingErrorMonitor> following_;           ///< Set if the machine has servo loops.
};

}  // namespace gsim::simulation
