#include "runtime/script/processes/process_robots.h"

#include <algorithm>

#include <fmt/format.h>

namespace gsim::script {

using text::DiagnosticKind;

using process::Process;
using process::ProcessId;

RobotController* ProcessRobots::find(std::string_view name) const {
    const auto found =
        std::find_if(controllers_.begin(), controllers_.end(),
                     [&](const RobotController* controller) { return controller->name() == name; });
    return found == controllers_.end() ? nullptr : *found;
}

std::vector<std::string_view> ProcessRobots::names() const {
    std::vector<std::string_view> names;
    names.reserve(controllers_.size());
    for (const RobotController* controller : controllers_) {
        if (!controller->name().empty()) names.push_back(controller->name());
    }
    return names;
}

RobotController& ProcessRobots::with_interpreter(const Interpreter& interpreter) const {
    return **std::find_if(controllers_.begin(), controllers_.end(), [&](RobotController* controller) {
        return &controller->interpreter() == &interpreter;
    });
}

RobotController& ProcessRobots::controller_of(ProcessId id) const {
    RobotController* controller = table_.lua_process(id).controller;
    return controller != nullptr ? *controller : *controllers_[0];
}

bool ProcessRobots::has_alarm() const {
    return std::any_of(controllers_.begin(), controllers_.end(), [](RobotController* controller) {
        return controller->simulator().outcome().alarm().has_value();
    });
}

bool ProcessRobots::has_conveyors() const {
    return std::any_of(controllers_.begin(), controllers_.end(), [](RobotController* controller) {
        return controller->simulator().cell().has_conveyors();
    });
}

void ProcessRobots::assign(LuaProcess& lua_process, RobotController* controller) {
    if (lua_process.controller != nullptr) lua_process.controller->interpreter().set_attached(false);
    lua_process.controller = controller;
    if (controller == nullptr) return;
    lua_process.robot = controller->name();
    controller->interpreter().set_attached(true);
}

void ProcessRobots::attach_running() const {
    for (RobotController* controller : controllers_)
        controller->interpreter().set_attached(controller == table_.running_lua().controller);
}

void ProcessRobots::check_free(lua_State* state, const RobotController& controller) const {
    for (ProcessId id = 0; id < table_.size(); ++id) {
        if (table_.lua_process(id).controller != &controller || id == table_.running_id()) continue;
        alarm(state, DiagnosticKind::process,
              fmt::format("the robot{} belongs to the process '{}' as long as that process runs",
                          controller.name().empty() ? "" : fmt::format(" '{}'", controller.name()),
                          table_.schedule().process(id).name));
    }
}

void ProcessRobots::add_idle_time() const {
    LuaProcess& lua_process = table_.running_lua();
    if (lua_process.controller == nullptr) return;
    Process& process = table_.running();
    simulation::Simulator& simulator = lua_process.controller->simulator();
    const double idle_s = process.time_s - simulator.clock().planned_s();
    if (!(idle_s > 0) || lua_process.yield_reason == YieldReason::at_block) return;
    lua_process.idle_s += idle_s;
    lua_process.controller->add_idle_seconds(idle_s);
    simulator.dwells().enqueue(idle_s, process.location);
    process.time_s = std::max(process.time_s, simulator.clock().planned_s());
}

void ProcessRobots::bring_to_standstill(lua_State* state) const {
    Process& process = table_.running();
    if (const simulation::SourceLocation location = source_locator_.current(state); location.line > 0)
        process.location = location;
    RobotController* controller = table_.running_lua().controller;
    if (controller == nullptr) return;
    controller->interpreter().locate(state);
    controller->flush(state);
    controller->simulator().clock().wait();
    process.time_s = std::max(process.time_s, controller->simulator().clock().planned_s());
}

void ProcessRobots::alarm(lua_State* state, DiagnosticKind kind, const std::string& message) const {
    interpreter().locate(state);
    interpreter().alarm(state, kind, message);
}

}  // namespace gsim::script
