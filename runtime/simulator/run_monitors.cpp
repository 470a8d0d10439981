#include "runtime/simulator/run_monitors.h"

#include <utility>

#include <fmt/format.h>

#include "runtime/monitors/axis_acceleration_time_monitor.h"
#include "runtime/monitors/following_monitor.h"
#include "runtime/simulator/machine_dynamics.h"

namespace gsim::simulation {

RunMonitors::RunMonitors(const machine::Machine& machine, MachineMotion& motion,
                         const std::vector<Eigen::Vector3d>& tcps_mm, Warnings& warnings)
    : machine_(machine),
      motion_(motion),
      tcps_mm_(tcps_mm),
      warnings_(warnings),
      centripetal_monitor_(machine) {
    motion.recorder().add_output(centripetal_monitor_);
    motion.recorder().add_output(early_braking_monitor_);
    start_following_error();
}

RunMonitors::~RunMonitors() = default;

void RunMonitors::start_following_error() {
    const auto setup = following_setup();
    if (!setup) return;
    following_ = std::make_unique<FollowingErrorMonitor>(*setup);
    motion_.add_path_sink(following_->path_sink());
    motion_.recorder().add_output(*following_);
}

void RunMonitors::start_interval() {
    if (machine_.calibration) motion_.observe(interval_monitor_.emplace(machine_));
}

void RunMonitors::set_dynamics(std::shared_ptr<const dynamics::Dynamics> dynamics) {
    dynamics_ = std::move(dynamics);
    if (dynamics_ == nullptr) return;
    motion_.recorder().add_output(efforts_.emplace(machine_, *dynamics_));
    apply_torque_limits();
}

void RunMonitors::apply_torque_limits() {
    std::shared_ptr<const motion::MoveLimits> limits = make_effort_limits(machine_, dynamics_);
    if (limits == nullptr) return;
    if (!motion_.set_move_limits(std::move(limits))) {
        return warnings_.add(
            "the controller is a module: it does not support 'limit = \"torque\"' of the machine file");
    }
    axis_acceleration_time_monitor_ = std::make_unique<AxisAccelerationTimeMonitor>(machine_);
    motion_.observe(*axis_acceleration_time_monitor_);
}

std::optional<FollowingSetup> RunMonitors::following_setup() const {
    if (!has_servos(machine_)) return std::nullopt;
    return FollowingSetup{machine_, motion_.setup(), tcps_mm_};
}

void RunMonitors::add_warnings(const std::vector<std::string>& files, Report& report) const {
    if (const auto warning = centripetal_monitor_.warning(files))
        report.messages.warnings.push_back(*warning);
    if (const auto warning = early_braking_monitor_.warning(files))
        report.messages.warnings.push_back(*warning);
}

void RunMonitors::add_results(RunStatus status, const std::vector<std::string>& programs,
                              Report& report) const {
    add_efforts(status, programs, report);
    add_interval(status, report);
    add_following(report);
}

void RunMonitors::add_efforts(RunStatus status, const std::vector<std::string>& programs,
                              Report& report) const {
    if (!efforts_) return;
    report.drives.efforts = efforts_->report(programs);
    if (axis_acceleration_time_monitor_ == nullptr || status != RunStatus::completed) return;
    report.drives.efforts->time_by_axis_accelerations_s = axis_acceleration_time_monitor_->time_s();
    if (report.drives.efforts->time_by_axis_accelerations_s || report.cycle_time_s <= 0) return;
    report.messages.warnings.push_back(fmt::format(
        "torques limit the accelerations, and the time with the axis accelerations is unknown: {}",
        axis_acceleration_time_monitor_->error()));
}

void RunMonitors::add_interval(RunStatus status, Report& report) const {
    if (!interval_monitor_ || status != RunStatus::completed) return;
    report.times.interval = interval_monitor_->interval(report.cycle_time_s);
    if (report.times.interval || report.cycle_time_s <= 0) return;
    report.messages.warnings.push_back(fmt::format(
        "the machine is calibrated, but the cycle time has no interval: {}", interval_monitor_->error()));
}

void RunMonitors::add_following(Report& report) const {
    if (following_ == nullptr) return;
    report.drives.following = following_->report();
    if (motion_.source().is_sampled()) report.drives.following->program.reset();  // a module reports no paths
}

}  // namespace gsim::simulation
