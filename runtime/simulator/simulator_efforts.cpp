#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "runtime/monitors/axes_time_monitor.h"
#include "runtime/monitors/following_monitor.h"
#include "runtime/simulator/machine_dynamics.h"
#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

void Simulator::set_dynamics(std::shared_ptr<const dynamics::Dynamics> dynamics) {
    dynamics_ = std::move(dynamics);
    if (dynamics_ == nullptr) return;
    recorder_.add_output(efforts_.emplace(machine_, *dynamics_));
    apply_torque_limits();
}

void Simulator::apply_torque_limits() {
    setup_.move_limits = make_effort_limits(machine_, dynamics_);
    if (setup_.move_limits == nullptr) return;
    if (!motion_->set_move_limits(setup_.move_limits)) {
        setup_.move_limits = nullptr;
        return warn("the controller is a module: it does not know 'limit = \"torque\"' of the machine file");
    }
    axes_time_monitor_ = std::make_unique<AxesTimeMonitor>(machine_);
    observe_motion(*axes_time_monitor_);
}

void Simulator::add_efforts(Report& report) const {
    if (!efforts_) return;
    report.efforts = efforts_->report(programs_);
    if (axes_time_monitor_ == nullptr || status_ != RunStatus::completed) return;
    report.efforts->time_by_axis_accelerations_s = axes_time_monitor_->time_s();
    if (report.efforts->time_by_axis_accelerations_s || report.cycle_time_s <= 0) return;
    report.warnings.push_back(
        fmt::format("torques limit the accelerations, and what the moves take with those of the axes is not "
                    "known: {}",
                    axes_time_monitor_->error()));
}

Simulator::~Simulator() = default;

void Simulator::start_following_monitor() {
    path_sinks_.add(path_deviation_monitor_);
    const auto setup = following_setup();
    if (!setup) return;
    following_ = std::make_unique<FollowingMonitor>(*setup);
    path_sinks_.add(following_->ways());
    recorder_.add_output(*following_);
}

void Simulator::add_following(Report& report) const {
    if (following_ == nullptr) return;
    report.following = following_->report();
    if (is_sampled()) report.following->program.reset();  // a module reports no paths
}

std::optional<FollowingSetup> Simulator::following_setup() const {
    if (!has_servos(machine_)) return std::nullopt;
    return FollowingSetup{machine_, setup_, tcps_.list_mm()};
}

// Programs past the max count are recorded as the main one.
void Simulator::open_program(const std::string& name) {
    const auto found = std::find(programs_.begin(), programs_.end(), name);
    const auto index = static_cast<std::size_t>(found - programs_.begin());
    if (found == programs_.end() && index <= std::numeric_limits<std::uint16_t>::max())
        programs_.push_back(name);
    open_programs_.push_back(index < programs_.size() ? static_cast<std::uint16_t>(index) : std::uint16_t{0});
}

}  // namespace gsim::simulation
