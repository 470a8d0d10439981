// Motion outside of a process: conveyors and their speeds, the robots that follow them, and the time up to
// which the motion of all is known.

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "runtime/script/processes/processes.h"

namespace gsim::script {

using text::DiagnosticKind;

using process::ProcessId;

process::Conveyor* Processes::find_conveyor(std::string_view name) {
    const auto found =
        std::find_if(conveyors_.begin(), conveyors_.end(),
                     [&](const process::Conveyor& conveyor) { return conveyor.name() == name; });
    return found == conveyors_.end() ? nullptr : &*found;
}

void Processes::set_conveyor_speed(lua_State* state, process::Conveyor& conveyor, double speed_mm_s) {
    for (const auto& [controller, followed] : tracked_conveyors_) {
        if (followed != &conveyor) continue;
        alarm(
            state, DiagnosticKind::process,
            fmt::format("the speed of the conveyor '{}' cannot change while {} follows it", conveyor.name(),
                        controller->name().empty() ? "the robot" : fmt::format("'{}'", controller->name())));
    }
    conveyor.set_speed(speed_mm_s, time_s());
    notify_conveyor(conveyor, time_s());
    set_signal(conveyor.name() + ".speed", speed_mm_s);
}

bool Processes::tracks_conveyors() const {
    return std::any_of(controllers_.begin(), controllers_.end(),
                       [](RobotController* controller) { return controller->simulator().has_conveyors(); });
}

/// Sets the conveyor's motion from a time on in the cells of robots through which it runs.
void Processes::notify_conveyor(const process::Conveyor& conveyor, double time_s) {
    for (RobotController* controller : controllers_) {
        const Eigen::Vector3d direction = controller->base().linear().transpose() * conveyor.direction();
        controller->simulator().set_conveyor(conveyor.name(), conveyor.position_mm(time_s) * direction,
                                             conveyor.speed_mm_s() * direction, time_s);
    }
}

/// A process changes conveyors only at its own time, with its own robot at standstill.
void Processes::notify_known_conveyor_time() {
    for (RobotController* controller : controllers_) {
        if (!controller->simulator().has_conveyors()) continue;
        double known_s = std::numeric_limits<double>::infinity();
        for (ProcessId id = 0; id < lua_processes_.size(); ++id) {
            if (lua_processes_[id]->controller != controller)
                known_s = std::min(known_s, schedule_.next_action_s(id));
        }
        controller->simulator().set_conveyors_known_until(known_s);
    }
}

void Processes::notify_known_time() {
    notify_known_conveyor_time();
    if (multi_robot_monitor_ == nullptr) return;
    double known_s = std::numeric_limits<double>::infinity();
    for (ProcessId id = 0; id < lua_processes_.size(); ++id)
        known_s = std::min(known_s, schedule_.next_action_s(id));
    multi_robot_monitor_->set_known_until(known_s);
}

void Processes::set_multi_robot_monitor(simulation::MultiRobotMonitor& monitor) {
    multi_robot_monitor_ = &monitor;
    monitor.on_buffer_full([this] {
        if (!lua_process().threads.empty()) lua_.set_line_hook(lua_process().threads.front().state, true);
    });
}

void Processes::track(lua_State* state, RobotController& controller, process::Conveyor* conveyor) {
    controller.interpreter().attach(state);
    controller.interpreter().locate(state);
    simulation::Simulator& simulator = controller.simulator();
    const simulation::SourceLocation location = controller.interpreter().location();
    if (tracked_conveyors_.erase(&controller) > 0)
        controller.interpreter().check(state, simulator.untrack(location));
    if (conveyor != nullptr) {
        tracked_conveyors_.emplace(&controller, conveyor);
        const Eigen::Vector3d direction = controller.base().linear().transpose() * conveyor->direction();
        const bool done = simulator.track(direction, conveyor->position_mm(simulator.time_s()),
                                          conveyor->speed_mm_s(), location);
        controller.interpreter().check(state, done);
    }
    now().time_s = std::max(now().time_s, simulator.time_s());
}

}  // namespace gsim::script
