#include "runtime/script/processes/processes.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace gsim::script {

using text::DiagnosticKind;

using process::Process;
using process::ProcessId;
using process::ProcessState;

Processes::Processes(LuaState& lua, SourceLocator& locations, std::vector<RobotController*> controllers,
                     std::vector<process::Conveyor> conveyors)
    : lua_(lua),
      source_locator_(locations),
      robots_(table_, locations, std::move(controllers)),
      known_motion_(table_, robots_),
      signals_(lua, table_, robots_),
      conveyors_(table_, robots_, signals_, std::move(conveyors)),
      zones_(table_, robots_, known_motion_) {
    for (RobotController* controller : robots_.controllers()) {
        controller->interpreter().on_foreign_word(
            [this](lua_State* state, Interpreter& interpreter) { attach(state, interpreter); });
    }
    lua_.on_line([this](lua_State* state, lua_Debug* line) { on_line_hook(state, line); });
}

void Processes::set_multi_robot_monitor(simulation::MultiRobotMonitor& monitor) {
    known_motion_.set_multi_robot_monitor(monitor);
    monitor.on_buffer_full([this] {
        const std::vector<LuaProcess::Thread>& threads = table_.running_lua().threads;
        if (!threads.empty()) lua_.set_line_hook(threads.front().state, true);
    });
}

Processes::Outcome Processes::run(lua_State* state) {
    conveyors_.start();
    start(state, "main", false);
    const std::vector<RobotController*>& controllers = robots_.controllers();
    if (controllers.size() == 1) {
        ProcessRobots::assign(table_.lua_process(0), controllers[0]);
        known_motion_.on_robot_owner(*controllers[0]);
    }
    while (const std::optional<ProcessId> id = table_.schedule().activate_next()) {
        if (std::optional<Outcome> outcome = resume(*id)) return *std::move(outcome);
    }
    return table_.schedule().has_unfinished() ? deadlock() : Outcome{.controller = controllers[0]};
}

Processes::Outcome Processes::deadlock() {
    const process::Schedule& schedule = table_.schedule();
    ProcessId first = 0;
    while (schedule.process(first).background || schedule.process(first).state == ProcessState::done) ++first;
    RobotController& controller = robots_.controller_of(first);
    return {.end = RunEnd::deadlock,
            .message = fmt::format("{}no process can continue: {}",
                                   schedule.any_waits_for_zone() ? "deadlock, " : "",
                                   schedule.waits(controller.simulator().program().files().names())),
            .controller = &controller,
            .location = schedule.process(first).location};
}

/// Returns a deadlock if another process waits for a zone that this ended process has kept. It would wait
/// indefinitely, regardless of the others.
std::optional<Processes::Outcome> Processes::find_deadlock(ProcessId id) {
    const process::Schedule& schedule = table_.schedule();
    const std::optional<ProcessId> first = schedule.find_zone_waiter(id);
    if (!first) return std::nullopt;
    RobotController& controller = robots_.controller_of(*first);
    const std::string waits =
        schedule.waits(controller.simulator().program().files().names(), schedule.deadlocked_from(*first));
    return Outcome{.end = RunEnd::deadlock,
                   .message = "deadlock: " + waits,
                   .controller = &controller,
                   .location = schedule.process(*first).location};
}

// --- Threads ---

/// Moves the function on top of the stack of `from` to a thread of its own. It has the hook of the main
/// state.
LuaProcess::Thread Processes::new_thread(lua_State* from) {
    LuaProcess::Thread thread;
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
    const bool first = table_.size() == 0;
    const double start_s = first ? 0 : time_s();
    LuaProcess& added = table_.add(std::move(name), background, start_s, source_locator_.current(state));
    added.threads.push_back(new_thread(state));
    lua_.set_line_hook(added.threads.front().state, robots_.has_conveyors());
    known_motion_.update();
}

/// Runs the process until it yields or ends; returns an outcome if the run is over.
std::optional<Processes::Outcome> Processes::resume(ProcessId id) {
    table_.set_running(id);
    LuaProcess& lua_process = table_.lua_process(id);
    robots_.attach_running();
    robots_.add_idle_time();
    known_motion_.update();
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
    const bool stopped = status == LUA_ERRRUN && LuaState::is_stop(thread, -1);
    if (status != LUA_OK && (!stopped || robots_.has_alarm() || lua_.ended() != LuaState::StopReason::no)) {
        return Outcome{.end = RunEnd::error,
                       .error_thread = thread,
                       .status = status,
                       .controller = &robots_.controller_of(id)};
    }
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
    lua_pushboolean(lua_process.threads.back().state, static_cast<int>(!table_.running().timed_out));
    return 1;
}

void Processes::start_interrupt(LuaProcess& lua_process) {
    lua_State* state = lua_.get();
    robots_.controllers()[0]->push_library(state, "run_interrupt");
    const LuaProcess::Thread thread = new_thread(state);
    lua_rawgeti(thread.state, LUA_REGISTRYINDEX, lua_process.pending.front());
    lua_process.pending.pop_front();
    lua_process.threads.push_back(thread);
    lua_process.yield_reason = YieldReason::to_interrupt;
}

void Processes::finish(ProcessId id) {
    LuaProcess& lua_process = table_.lua_process(id);
    Process& process = table_.schedule().process(id);
    if (several() && lua_process.controller != nullptr)
        process.time_s = std::max(process.time_s, lua_process.controller->simulator().clock().time_s());
    ProcessRobots::assign(lua_process, nullptr);
    while (!lua_process.threads.empty()) drop_thread(lua_process);
    table_.schedule().finish(id);
}

/// Attaches a robot if the running process calls a word of a robot that it does not have.
void Processes::attach(lua_State* state, const Interpreter& requested) {
    RobotController& controller = robots_.with_interpreter(requested);
    robots_.check_free(state, controller);
    robots_.bring_to_standstill(state);
    ProcessRobots::assign(table_.running_lua(), &controller);
    Process& process = table_.running();
    process.time_s = std::max(process.time_s, controller.simulator().clock().time_s());
    known_motion_.on_robot_owner(controller);
    robots_.add_idle_time();
}

// --- Requests of the running process ---

void Processes::count_join(lua_State* state) {
    simulation::Simulator& simulator = robots_.interpreter().simulator();
    if (++joins_ <= simulator.outcome().limits().max_blocks) return;
    simulator.outcome().stop(
        DiagnosticKind::run_limit,
        fmt::format("the processes have called join {} times (--max-blocks)", joins_ - 1),
        table_.running().location);
    LuaState::raise_stop(state);
}

int Processes::join(lua_State* state) {
    robots_.bring_to_standstill(state);
    count_join(state);
    simulation::Simulator& simulator = robots_.interpreter().simulator();
    if (time_s() > simulator.outcome().limits().max_time_s) {
        simulator.outcome().stop(DiagnosticKind::run_limit,
                                 fmt::format("the limit of {:.10g} s of machine time is reached (--max-time)",
                                             simulator.outcome().limits().max_time_s),
                                 table_.running().location);
        LuaState::raise_stop(state);
    }
    return table_.schedule().continues(table_.running_id()) ? 0 : table_.yield(state, YieldReason::to_join);
}

int Processes::wait(lua_State* state, double seconds) {
    robots_.bring_to_standstill(state);
    Process& process = table_.running();
    const double end_s = process.time_s + seconds;
    if (RobotController* controller = table_.running_lua().controller; controller != nullptr)
        controller->interpreter().check(state,
                                        controller->simulator().dwells().enqueue(seconds, process.location));
    process.time_s = end_s;
    if (seconds > 0) lua_.restart_steps();
    return join(state);
}

/// A process that can be interrupted is about to run another line, so all events up to its time must be
/// known. The same applies if its robot is far ahead of others that are checked against it.
void Processes::on_line_hook(lua_State* state, lua_Debug* line) {
    LuaProcess& lua_process = table_.running_lua();
    if (lua_process.threads.size() > 1 || lua_isyieldable(state) == 0) return;
    lua_getinfo(state, "S", line);
    if (line->source[0] != '=' || line->source[1] != '#') return;
    Process& process = table_.running();
    if (lua_process.controller != nullptr)
        process.time_s = std::max(process.time_s, lua_process.controller->simulator().clock().planned_s());
    if (!signals_.needs_line_hook(lua_process)) {
        lua_.set_line_hook(state, false);
        known_motion_.update();
    }
    if (table_.schedule().continues(table_.running_id()) && lua_process.pending.empty()) return;
    table_.yield(state, YieldReason::at_block);
}

std::vector<simulation::ProcessSummary> Processes::summaries() const {
    std::vector<simulation::ProcessSummary> list;
    list.reserve(table_.size());
    for (ProcessId id = 0; id < table_.size(); ++id) {
        const Process& process = table_.schedule().process(id);
        const bool waiting = process.state == ProcessState::waiting;
        list.push_back({.name = process.name,
                        .robot = table_.lua_process(id).robot,
                        .state = process.state == ProcessState::done ? "done"
                                 : waiting                           ? "waiting"
                                                                     : "stopped",
                        .background = process.background,
                        .start_s = process.start_s,
                        .end_s = process.time_s,
                        .idle_s = table_.lua_process(id).idle_s});
    }
    return list;
}

}  // namespace gsim::script
