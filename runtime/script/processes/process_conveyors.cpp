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
    for (const auto& [control, followed] : tracked_) {
        if (followed != &conveyor) continue;
        alarm(state, DiagnosticKind::process,
              fmt::format("the speed of the conveyor '{}' cannot change while {} follows it", conveyor.name(),
                          control->name().empty() ? "the robot" : fmt::format("'{}'", control->name())));
    }
    conveyor.set_speed(speed_mm_s, time_s());
    tell_conveyor(conveyor, time_s());
    set_signal(conveyor.name() + ".speed", speed_mm_s);
}

bool Processes::follows_conveyors() const {
    return std::any_of(controls_.begin(), controls_.end(),
                       [](Control* control) { return control->simulator().has_conveyors(); });
}

/// Sets the conveyor's motion from a time on in the cells of robots through which it runs.
void Processes::tell_conveyor(const process::Conveyor& conveyor, double time_s) {
    for (Control* control : controls_) {
        const Eigen::Vector3d direction = control->base().linear().transpose() * conveyor.direction();
        control->simulator().set_conveyor(conveyor.name(), conveyor.position_mm(time_s) * direction,
                                          conveyor.speed_mm_s() * direction, time_s);
    }
}

/// A process changes conveyors only at its own time, with its own robot at standstill.
void Processes::tell_known_time_of_conveyors() {
    for (Control* control : controls_) {
        if (!control->simulator().has_conveyors()) continue;
        double known_s = std::numeric_limits<double>::infinity();
        for (ProcessId id = 0; id < strands_.size(); ++id) {
            if (strands_[id]->control != control) known_s = std::min(known_s, schedule_.next_act_s(id));
        }
        control->simulator().know_conveyors_until(known_s);
    }
}

void Processes::tell_known_time() {
    tell_known_time_of_conveyors();
    if (robots_watch_ == nullptr) return;
    double known_s = std::numeric_limits<double>::infinity();
    for (ProcessId id = 0; id < strands_.size(); ++id) known_s = std::min(known_s, schedule_.next_act_s(id));
    robots_watch_->know_until(known_s);
}

void Processes::watch_robots(simulation::RobotsWatch& watch) {
    robots_watch_ = &watch;
    watch.on_far_ahead([this] {
        if (!strand().threads.empty()) lua_.watch_lines(strand().threads.front().state, true);
    });
}

void Processes::track(lua_State* state, Control& control, process::Conveyor* conveyor) {
    control.interpreter().attach(state);
    control.interpreter().locate(state);
    simulation::Simulator& simulator = control.simulator();
    const simulation::Place place = control.interpreter().place();
    if (tracked_.erase(&control) > 0) control.interpreter().check(state, simulator.untrack(place));
    if (conveyor != nullptr) {
        tracked_.emplace(&control, conveyor);
        const Eigen::Vector3d direction = control.base().linear().transpose() * conveyor->direction();
        const bool done = simulator.track(direction, conveyor->position_mm(simulator.time_s()),
                                          conveyor->speed_mm_s(), place);
        control.interpreter().check(state, done);
    }
    now().time_s = std::max(now().time_s, simulator.time_s());
}

}  // namespace gsim::script
