#include "runtime/script/processes/processes.h"

#include <algorithm>

#include <fmt/format.h>

namespace gsim::script {

using text::DiagnosticKind;

using process::is_on;
using process::Process;
using process::ProcessId;
using process::ProcessState;
using process::Value;
using process::value_text;

Processes::Processes(LuaState& lua, SourceLocator& locations, std::vector<RobotController*> controllers,
                     std::vector<process::Conveyor> conveyors)
    : lua_(lua),
      source_locator_(locations),
      controllers_(std::move(controllers)),
      conveyors_(std::move(conveyors)) {
    for (RobotController* controller : controllers_) {
        controller->interpreter().on_foreign_word(
            [this](lua_State* state, Interpreter& interpreter) { attach(state, interpreter); });
    }
    lua_.on_line([this](lua_State* state, lua_Debug* line) { on_line_hook(state, line); });
}

Processes::Outcome Processes::run(lua_State* state) {
    for (const process::Conveyor& conveyor : conveyors_) notify_conveyor(conveyor, 0);
    start(state, "main", false);
    if (controllers_.size() == 1) {
        assign_robot(*lua_processes_[0], controllers_[0]);
        notify_robot_owner(controllers_[0]);
    }
    while (const std::optional<ProcessId> id = schedule_.activate_next()) {
        if (std::optional<Outcome> outcome = resume(*id)) return *std::move(outcome);
    }
    return schedule_.has_unfinished() ? deadlock() : Outcome{.controller = controllers_[0]};
}

Processes::Outcome Processes::deadlock() {
    ProcessId first = 0;
    while (schedule_.process(first).background || schedule_.process(first).state == ProcessState::done)
        ++first;
    RobotController* controller = lua_processes_[first]->controller;
    if (controller == nullptr) controller = controllers_[0];
    return {
        .end = RunEnd::deadlock,
        .message = fmt::format("{}nothing can go on: {}", schedule_.any_waits_for_zone() ? "dead-lock, " : "",
                               schedule_.waits(controller->simulator().files())),
        .controller = controller,
        .location = schedule_.process(first).location};
}

// --- Threads ---

/// Moves the function on top of the stack of `from` to a thread of its own. It has the hook of the main
/// state.
Processes::Thread Processes::new_thread(lua_State* from) {
    Thread thread;
    thread.state = lua_newthread(lua_.get());
    thread.reference = luaL_ref(lua_.get(), LUA_REGISTRYINDEX);
    lua_xmove(from, thread.state, 1);
    return thread;
}

void Processes::drop_thread(LuaProcess& lua_process) {
    luaL_unref(lua_.get(), LUA_REGISTRYINDEX, lua_process.threads.back().reference);
    lua_process.threads.pop_back();
}

void Processes::start(lua_State* state, std::string name, bool background) {
    const bool first = lua_processes_.empty();
    const double start_s = first ? 0 : time_s();
    schedule_.add(std::move(name), background, start_s, source_locator_.current(state));
    lua_processes_.push_back(std::make_unique<LuaProcess>());
    lua_processes_.back()->threads.push_back(new_thread(state));
    lua_.set_line_hook(lua_processes_.back()->threads.front().state, tracks_conveyors());
    notify_known_time();
}

/// Runs the process until it yields or ends; returns an outcome if the run is over.
std::optional<Processes::Outcome> Processes::resume(ProcessId id) {
    running_ = id;
    LuaProcess& lua_process = *lua_processes_[id];
    for (RobotController* controller : controllers_)
        controller->interpreter().set_attached(controller == lua_process.controller);
    add_idle_time(lua_process);
    notify_known_time();
    if (lua_process.yield_reason == YieldReason::at_block && !lua_process.pending.empty())
        start_interrupt(lua_process);
    const int arguments = push_resume_arguments(lua_process);
    lua_State* thread = lua_process.threads.back().state;
    lua_.set_running(thread);
    int results = 0;
    const int status = lua_resume(thread, lua_.get(), arguments, &results);
    lua_.set_running(lua_.get());
    if (status == LUA_YIELD) {
        lua_pop(thread, results);
        return std::nullopt;
    }
    RobotController* controller =
        lua_process.controller != nullptr ? lua_process.controller : controllers_[0];
    const bool stopped = status == LUA_ERRRUN && LuaState::is_stop(thread, -1);
    const bool has_alarm = std::any_of(controllers_.begin(), controllers_.end(), [](RobotController* each) {
        return each->simulator().alarm().has_value();
    });
    if (status != LUA_OK && (!stopped || has_alarm || lua_.ended() != LuaState::StopReason::no))
        return Outcome{
            .end = RunEnd::error, .error_thread = thread, .status = status, .controller = controller};
    if (status == LUA_OK && lua_process.threads.size() > 1) {  // the end of an interrupt
        drop_thread(lua_process);
        lua_process.yield_reason = YieldReason::at_block;
        return std::nullopt;
    }
    finish(id);
    return find_deadlock(id);
}

/// Passes to a thread that waited if its wait succeeded or timed out.
int Processes::push_resume_arguments(LuaProcess& lua_process) {
    const YieldReason yield_reason = std::exchange(lua_process.yield_reason, YieldReason::to_join);
    if (yield_reason == YieldReason::to_interrupt) return 1;  // with its function
    if (yield_reason != YieldReason::in_wait) return 0;
    lua_pushboolean(lua_process.threads.back().state, static_cast<int>(!now().timed_out));
    return 1;
}

void Processes::start_interrupt(LuaProcess& lua_process) {
    lua_State* state = lua_.get();
    controllers_[0]->push_library(state, "run_interrupt");
    const Thread thread = new_thread(state);
    lua_rawgeti(thread.state, LUA_REGISTRYINDEX, lua_process.pending.front());
    lua_process.pending.pop_front();
    lua_process.threads.push_back(thread);
    lua_process.yield_reason = YieldReason::to_interrupt;
}

void Processes::finish(ProcessId id) {
    LuaProcess& lua_process = *lua_processes_[id];
    Process& process = schedule_.process(id);
    if (several() && lua_process.controller != nullptr)
        process.time_s = std::max(process.time_s, lua_process.controller->simulator().time_s());
    assign_robot(lua_process, nullptr);
    while (!lua_process.threads.empty()) drop_thread(lua_process);
    schedule_.finish(id);
}

// --- Robots ---

Interpreter& Processes::interpreter() {
    RobotController* controller = lua_process().controller;
    return (controller != nullptr ? controller : controllers_[0])->interpreter();
}

RobotController* Processes::find_controller(std::string_view name) const {
    const auto found =
        std::find_if(controllers_.begin(), controllers_.end(),
                     [&](const RobotController* controller) { return controller->name() == name; });
    return found == controllers_.end() ? nullptr : *found;
}

std::vector<std::string_view> Processes::controller_names() const {
    std::vector<std::string_view> names;
    names.reserve(controllers_.size());
    for (const RobotController* controller : controllers_) {
        if (!controller->name().empty()) names.push_back(controller->name());
    }
    return names;
}

void Processes::assign_robot(LuaProcess& lua_process, RobotController* controller) {
    if (lua_process.controller != nullptr) lua_process.controller->interpreter().set_attached(false);
    lua_process.controller = controller;
    if (controller == nullptr) return;
    lua_process.robot = controller->name();
    controller->interpreter().set_attached(true);
}

/// Attaches a robot if the running process calls a word of a robot that it does not have.
void Processes::attach(lua_State* state, Interpreter& requested) {
    const auto is_requested = [&](RobotController* controller) {
        return &controller->interpreter() == &requested;
    };
    RobotController* controller = *std::find_if(controllers_.begin(), controllers_.end(), is_requested);
    for (ProcessId id = 0; id < lua_processes_.size(); ++id) {
        if (lua_processes_[id]->controller != controller || id == running_) continue;
        alarm(state, DiagnosticKind::process,
              fmt::format("the robot{} belongs to the process '{}' as long as that runs",
                          controller->name().empty() ? "" : fmt::format(" '{}'", controller->name()),
                          schedule_.process(id).name));
    }
    bring_to_standstill(state);
    assign_robot(lua_process(), controller);
    now().time_s = std::max(now().time_s, controller->simulator().time_s());
    notify_robot_owner(controller);
    add_idle_time(lua_process());
}

/// The clock of the robot follows that of its process.
void Processes::add_idle_time(LuaProcess& lua_process) {
    if (lua_process.controller == nullptr) return;
    simulation::Simulator& simulator = lua_process.controller->simulator();
    const double idle_s = now().time_s - simulator.planned_s();
    if (!(idle_s > 0) || lua_process.yield_reason == YieldReason::at_block) return;
    lua_process.idle_s += idle_s;
    lua_process.controller->add_idle(idle_s);
    simulator.dwell(idle_s, now().location);
    now().time_s = std::max(now().time_s, simulator.planned_s());
}

// --- Requests of the running process ---

void Processes::alarm(lua_State* state, DiagnosticKind kind, const std::string& message) {
    interpreter().locate(state);
    interpreter().alarm(state, kind, message);
}

void Processes::count_join(lua_State* state) {
    simulation::Simulator& simulator = interpreter().simulator();
    if (++joins_ <= simulator.max_blocks()) return;
    simulator.stop(DiagnosticKind::run_limit,
                   fmt::format("the processes have joined each other {} times (--max-blocks)", joins_ - 1),
                   now().location);
    LuaState::raise_stop(state);
}

void Processes::bring_to_standstill(lua_State* state) {
    Process& process = now();
    if (const simulation::SourceLocation location = source_locator_.current(state); location.line > 0)
        process.location = location;
    RobotController* controller = lua_process().controller;
    if (controller == nullptr) return;
    controller->interpreter().locate(state);
    controller->flush(state);
    controller->simulator().wait();
    process.time_s = std::max(process.time_s, controller->simulator().planned_s());
}

int Processes::yield(lua_State* state, YieldReason reason) {
    lua_process().yield_reason = reason;
    return lua_yield(state, 0);
}

int Processes::join(lua_State* state) {
    bring_to_standstill(state);
    count_join(state);
    simulation::Simulator& simulator = interpreter().simulator();
    if (now().time_s > simulator.max_time_s()) {
        simulator.stop(DiagnosticKind::run_limit,
                       fmt::format("the limit of {:.10g} s of machine time is reached (--max-time)",
                                   simulator.max_time_s()),
                       now().location);
        LuaState::raise_stop(state);
    }
    return schedule_.continues(running_) ? 0 : yield(state, YieldReason::to_join);
}

int Processes::wait(lua_State* state, double seconds) {
    bring_to_standstill(state);
    const double end_s = now().time_s + seconds;
    if (RobotController* controller = lua_process().controller; controller != nullptr)
        controller->interpreter().check(state, controller->simulator().dwell(seconds, now().location));
    now().time_s = end_s;
    if (seconds > 0) lua_.restart_steps();
    return join(state);
}

void Processes::set_signal(const std::string& name, const Value& value) {
    const Value before = signal_board_.get(name);
    if (!signal_board_.set(name, value)) return;
    signal_board_.note({.t_s = now().time_s,
                        .location = now().location,
                        .process = now().name,
                        .signal = name,
                        .value = value_text(value)});
    schedule_.changed(name, before, value, now().time_s);
    if (is_on(before) || !is_on(value)) return;
    for (const std::unique_ptr<LuaProcess>& lua_process : lua_processes_) {
        if (const auto handler = lua_process->handlers.find(name); handler != lua_process->handlers.end())
            lua_process->pending.push_back(handler->second);
    }
}

int Processes::wait_signal(lua_State* state, process::Wait wait) {
    if (is_met(wait, signal_board_.get(wait.signal))) {
        lua_pushboolean(state, 1);
        return 1;
    }
    schedule_.wait(running_, std::move(wait));
    return yield(state, YieldReason::in_wait);
}

void Processes::on_signal(lua_State* state, const std::string& name) {
    LuaProcess& lua_process = this->lua_process();
    if (const auto old = lua_process.handlers.find(name); old != lua_process.handlers.end()) {
        std::erase(lua_process.pending, old->second);
        luaL_unref(state, LUA_REGISTRYINDEX, old->second);
        lua_process.handlers.erase(old);
    }
    if (lua_isnil(state, -1)) {
        lua_pop(state, 1);
    } else {
        lua_process.handlers.emplace(name, luaL_ref(state, LUA_REGISTRYINDEX));
    }
    lua_.set_line_hook(lua_process.threads.front().state, needs_line_hook(lua_process));
}

/// A process that can be interrupted is about to run another line, so all events up to its time must be
/// known. The same applies if its robot is far ahead of others that are checked against it.
void Processes::on_line_hook(lua_State* state, lua_Debug* line) {
    LuaProcess& lua_process = this->lua_process();
    if (lua_process.threads.size() > 1 || lua_isyieldable(state) == 0) return;
    lua_getinfo(state, "S", line);
    if (line->source[0] != '=' || line->source[1] != '#') return;
    if (lua_process.controller != nullptr)
        now().time_s = std::max(now().time_s, lua_process.controller->simulator().planned_s());
    if (!needs_line_hook(lua_process)) {
        lua_.set_line_hook(state, false);
        notify_known_time();
    }
    if (schedule_.continues(running_) && lua_process.pending.empty()) return;
    yield(state, YieldReason::at_block);
}

std::vector<simulation::ProcessSummary> Processes::summaries() const {
    std::vector<simulation::ProcessSummary> list;
    list.reserve(lua_processes_.size());
    for (ProcessId id = 0; id < lua_processes_.size(); ++id) {
        const Process& process = schedule_.process(id);
        const bool waiting = process.state == ProcessState::waiting;
        list.push_back({.name = process.name,
                        .robot = lua_processes_[id]->robot,
                        .state = process.state == ProcessState::done ? "done"
                                 : waiting                           ? "waiting"
                                                                     : "stopped",
                        .background = process.background,
                        .start_s = process.start_s,
                        .end_s = process.time_s,
                        .idle_s = lua_processes_[id]->idle_s});
    }
    return list;
}

}  // namespace gsim::script
