#include "runtime/script/processes/process_conveyors.h"

#include <algorithm>

#include <fmt/format.h>

namespace gsim::script {

using text::DiagnosticKind;

process::Conveyor* ProcessConveyors::find(std::string_view name) {
    const auto found =
        std::find_if(conveyors_.begin(), conveyors_.end(),
                     [&](const process::Conveyor& conveyor) { return conveyor.name() == name; });
    return found == conveyors_.end() ? nullptr : &*found;
}

std::vector<std::string_view> ProcessConveyors::names() const {
    std::vector<std::string_view> names;
    names.reserve(conveyors_.size());
    for (const process::Conveyor& conveyor : conveyors_) names.push_back(conveyor.name());
    return names;
}

void ProcessConveyors::start() const {
    for (const process::Conveyor& conveyor : conveyors_) set_in_cells(conveyor, 0);
}

void ProcessConveyors::set_speed(lua_State* state, process::Conveyor& conveyor, double speed_mm_s) {
    for (const auto& [controller, followed] : tracked_conveyors_) {
        if (followed != &conveyor) continue;
        robots_.alarm(
            state, DiagnosticKind::process,
            fmt::format("the speed of the conveyor '{}' cannot change while {} tracks it", conveyor.name(),
                        controller->name().empty() ? "the robot" : fmt::format("'{}'", controller->name())));
    }
    const double time_s = table_.running().time_s;
    conveyor.set_speed(speed_mm_s, time_s);
    set_in_cells(conveyor, time_s);
    signals_.set(conveyor.name() + ".speed", speed_mm_s);
}

/// Sets the conveyor's motion from a time on in the cells of robots through which it runs.
void ProcessConveyors::set_in_cells(const process::Conveyor& conveyor, double time_s) const {
    for (RobotController* controller : robots_.controllers()) {
        const Eigen::Vector3d direction = controller->base().linear().transpose() * conveyor.direction();
        controller->simulator().cell().set_conveyor(conveyor.name(), conveyor.position_mm(time_s) * direction,
                                                    conveyor.speed_mm_s() * direction, time_s);
    }
}

void ProcessConveyors::track(lua_State* state, RobotController& controller, process::Conveyor* conveyor) {
    controller.interpreter().attach(state);
    controller.interpreter().locate(state);
    simulation::Simulator& simulator = controller.simulator();
    const simulation::SourceLocation location = controller.interpreter().location();
    if (tracked_conveyors_.erase(&controller) > 0)
        controller.interpreter().check(state, simulator.services().untrack(location));
    if (conveyor != nullptr) {
        tracked_conveyors_.emplace(&controller, conveyor);
        const Eigen::Vector3d direction = controller.base().linear().transpose() * conveyor->direction();
        const bool done = simulator.services().track(
            direction, conveyor->position_mm(simulator.clock().time_s()), conveyor->speed_mm_s(), location);
        controller.interpreter().check(state, done);
    }
    process::Process& process = table_.running();
    process.time_s = std::max(process.time_s, simulator.clock().time_s());
}

}  // namespace gsim::script
