#include "runtime/script/processes/processes.h"

#include <algorithm>

#include <fmt/format.h>

namespace gsim::script {

using text::DiagnosticKind;

using process::is_on;
using process::Process;
using process::ProcessId;
using process::ProcessState;
using process::text_of;
using process::Value;

Processes::Processes(LuaState& lua, PlaceFinder& places, std::vector<Control*> controls,
                     std::vector<process::Conveyor> conveyors)
    : lua_(lua), places_(places), controls_(std::move(controls)), conveyors_(std::move(conveyors)) {
    for (Control* control : controls_) {
        control->interpreter().on_foreign_word(
            [this](lua_State* state, Interpreter& interpreter) { attach(state, interpreter); });
    }
    lua_.on_line([this](lua_State* state, lua_Debug* line) { at_line(state, line); });
}

Processes::Outcome Processes::run(lua_State* state) {
    for (const process::Conveyor& conveyor : conveyors_) tell_conveyor(conveyor, 0);
    start(state, "main", false);
    if (controls_.size() == 1) {
        take(*strands_[0], controls_[0]);
        tell_owner(controls_[0]);
    }
    while (const std::optional<ProcessId> id = schedule_.take_next()) {
        if (std::optional<Outcome> outcome = go_on(*id)) return *std::move(outcome);
    }
    return schedule_.unfinished() ? deadlock() : Outcome{.control = controls_[0]};
}

Processes::Outcome Processes::deadlock() {
    ProcessId first = 0;
    while (schedule_.process(first).background || schedule_.process(first).state == ProcessState::done)
        ++first;
    Control* control = strands_[first]->control;
    if (control == nullptr) control = controls_[0];
    return {.end = End::deadlock,
            .message = fmt::format("{}nothing can go on: {}", schedule_.waits_for_zone() ? "dead-lock, " : "",
                                   schedule_.waits(control->simulator().files())),
            .control = control,
            .place = schedule_.process(first).place};
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

void Processes::drop_thread(Strand& strand) {
    luaL_unref(lua_.get(), LUA_REGISTRYINDEX, strand.threads.back().reference);
    strand.threads.pop_back();
}

void Processes::start(lua_State* state, std::string name, bool background) {
    const bool first = strands_.empty();
    const double start_s = first ? 0 : time_s();
    schedule_.add(std::move(name), background, start_s, places_.current(state));
    strands_.push_back(std::make_unique<Strand>());
    strands_.back()->threads.push_back(new_thread(state));
    lua_.watch_lines(strands_.back()->threads.front().state, follows_conveyors());
    tell_known_time();
}

/// Runs the process until it yields or ends; returns an outcome if the run is over.
std::optional<Processes::Outcome> Processes::go_on(ProcessId id) {
    running_ = id;
    Strand& strand = *strands_[id];
    for (Control* control : controls_) control->interpreter().set_attached(control == strand.control);
    stand_idle(strand);
    tell_known_time();
    if (strand.yielded == Yielded::at_block && !strand.pending.empty()) start_interrupt(strand);
    const int arguments = arguments_for(strand);
    lua_State* thread = strand.threads.back().state;
    lua_.set_running(thread);
    int results = 0;
    const int status = lua_resume(thread, lua_.get(), arguments, &results);
    lua_.set_running(lua_.get());
    if (status == LUA_YIELD) {
        lua_pop(thread, results);
        return std::nullopt;
    }
    Control* control = strand.control != nullptr ? strand.control : controls_[0];
    const bool stopped = status == LUA_ERRRUN && LuaState::is_stop(thread, -1);
    const bool alarmed = std::any_of(controls_.begin(), controls_.end(),
                                     [](Control* each) { return each->simulator().alarm().has_value(); });
    if (status != LUA_OK && (!stopped || alarmed || lua_.ended() != LuaState::Ended::no))
        return Outcome{.end = End::error, .fault = thread, .status = status, .control = control};
    if (status == LUA_OK && strand.threads.size() > 1) {  // the end of an interrupt
        drop_thread(strand);
        strand.yielded = Yielded::at_block;
        return std::nullopt;
    }
    finish(id);
    return stuck_behind(id);
}

/// Passes to a thread that waited if its wait succeeded or timed out.
int Processes::arguments_for(Strand& strand) {
    const Yielded yielded = std::exchange(strand.yielded, Yielded::to_join);
    if (yielded == Yielded::to_interrupt) return 1;  // with its function
    if (yielded != Yielded::in_wait) return 0;
    lua_pushboolean(strand.threads.back().state, static_cast<int>(!now().timed_out));
    return 1;
}

void Processes::start_interrupt(Strand& strand) {
    lua_State* state = lua_.get();
    controls_[0]->push_library(state, "run_interrupt");
    const Thread thread = new_thread(state);
    lua_rawgeti(thread.state, LUA_REGISTRYINDEX, strand.pending.front());
    strand.pending.pop_front();
    strand.threads.push_back(thread);
    strand.yielded = Yielded::to_interrupt;
}

void Processes::finish(ProcessId id) {
    Strand& strand = *strands_[id];
    Process& process = schedule_.process(id);
    if (several() && strand.control != nullptr)
        process.time_s = std::max(process.time_s, strand.control->simulator().time_s());
    take(strand, nullptr);
    while (!strand.threads.empty()) drop_thread(strand);
    schedule_.finish(id);
}

// --- Robots ---

Interpreter& Processes::interpreter() {
    Control* control = strand().control;
    return (control != nullptr ? control : controls_[0])->interpreter();
}

Control* Processes::find_control(std::string_view name) const {
    const auto found = std::find_if(controls_.begin(), controls_.end(),
                                    [&](const Control* control) { return control->name() == name; });
    return found == controls_.end() ? nullptr : *found;
}

std::vector<std::string_view> Processes::control_names() const {
    std::vector<std::string_view> names;
    names.reserve(controls_.size());
    for (const Control* control : controls_) {
        if (!control->name().empty()) names.push_back(control->name());
    }
    return names;
}

void Processes::take(Strand& strand, Control* control) {
    if (strand.control != nullptr) strand.control->interpreter().set_attached(false);
    strand.control = control;
    if (control == nullptr) return;
    strand.robot = control->name();
    control->interpreter().set_attached(true);
}

/// Attaches a robot if the running process calls a word of a robot that it does not have.
void Processes::attach(lua_State* state, Interpreter& wanted) {
    const auto is_wanted = [&](Control* control) { return &control->interpreter() == &wanted; };
    Control* control = *std::find_if(controls_.begin(), controls_.end(), is_wanted);
    for (ProcessId id = 0; id < strands_.size(); ++id) {
        if (strands_[id]->control != control || id == running_) continue;
        alarm(state, DiagnosticKind::process,
              fmt::format("the robot{} belongs to the process '{}' as long as that runs",
                          control->name().empty() ? "" : fmt::format(" '{}'", control->name()),
                          schedule_.process(id).name));
    }
    rest(state);
    take(strand(), control);
    now().time_s = std::max(now().time_s, control->simulator().time_s());
    tell_owner(control);
    stand_idle(strand());
}

/// The clock of the robot follows that of its process.
void Processes::stand_idle(Strand& strand) {
    if (strand.control == nullptr) return;
    simulation::Simulator& simulator = strand.control->simulator();
    const double idle_s = now().time_s - simulator.planned_s();
    if (!(idle_s > 0) || strand.yielded == Yielded::at_block) return;
    strand.idle_s += idle_s;
    strand.control->add_idle(idle_s);
    simulator.dwell(idle_s, now().place);
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
                   now().place);
    LuaState::raise_stop(state);
}

void Processes::rest(lua_State* state) {
    Process& process = now();
    if (const simulation::Place place = places_.current(state); place.line > 0) process.place = place;
    Control* control = strand().control;
    if (control == nullptr) return;
    control->interpreter().locate(state);
    control->flush(state);
    control->simulator().wait();
    process.time_s = std::max(process.time_s, control->simulator().planned_s());
}

int Processes::yield(lua_State* state, Yielded how) {
    strand().yielded = how;
    return lua_yield(state, 0);
}

int Processes::join(lua_State* state) {
    rest(state);
    count_join(state);
    simulation::Simulator& simulator = interpreter().simulator();
    if (now().time_s > simulator.max_time_s()) {
        simulator.stop(DiagnosticKind::run_limit,
                       fmt::format("the limit of {:.10g} s of machine time is reached (--max-time)",
                                   simulator.max_time_s()),
                       now().place);
        LuaState::raise_stop(state);
    }
    return schedule_.goes_on(running_) ? 0 : yield(state, Yielded::to_join);
}

int Processes::wait(lua_State* state, double seconds) {
    rest(state);
    const double end_s = now().time_s + seconds;
    if (Control* control = strand().control; control != nullptr)
        control->interpreter().check(state, control->simulator().dwell(seconds, now().place));
    now().time_s = end_s;
    if (seconds > 0) lua_.restart_steps();
    return join(state);
}

void Processes::set_signal(const std::string& name, const Value& value) {
    const Value before = board_.get(name);
    if (!board_.set(name, value)) return;
    board_.note({.t_s = now().time_s,
                 .place = now().place,
                 .process = now().name,
                 .signal = name,
                 .value = text_of(value)});
    schedule_.changed(name, before, value, now().time_s);
    if (is_on(before) || !is_on(value)) return;
    for (const std::unique_ptr<Strand>& strand : strands_) {
        if (const auto handler = strand->handlers.find(name); handler != strand->handlers.end())
            strand->pending.push_back(handler->second);
    }
}

int Processes::wait_signal(lua_State* state, process::Wait wait) {
    if (is_met(wait, board_.get(wait.signal))) {
        lua_pushboolean(state, 1);
        return 1;
    }
    schedule_.wait(running_, std::move(wait));
    return yield(state, Yielded::in_wait);
}

void Processes::on_signal(lua_State* state, const std::string& name) {
    Strand& strand = this->strand();
    if (const auto old = strand.handlers.find(name); old != strand.handlers.end()) {
        std::erase(strand.pending, old->second);
        luaL_unref(state, LUA_REGISTRYINDEX, old->second);
        strand.handlers.erase(old);
    }
    if (lua_isnil(state, -1)) {
        lua_pop(state, 1);
    } else {
        strand.handlers.emplace(name, luaL_ref(state, LUA_REGISTRYINDEX));
    }
    lua_.watch_lines(strand.threads.front().state, watches_lines(strand));
}

/// A process that can be interrupted is about to run another line, so all events up to its time must be
/// known. The same applies if its robot is far ahead of others that are checked against it.
void Processes::at_line(lua_State* state, lua_Debug* line) {
    Strand& strand = this->strand();
    if (strand.threads.size() > 1 || lua_isyieldable(state) == 0) return;
    lua_getinfo(state, "S", line);
    if (line->source[0] != '=' || line->source[1] != '#') return;
    if (strand.control != nullptr)
        now().time_s = std::max(now().time_s, strand.control->simulator().planned_s());
    if (!watches_lines(strand)) {
        lua_.watch_lines(state, false);
        tell_known_time();
    }
    if (schedule_.goes_on(running_) && strand.pending.empty()) return;
    yield(state, Yielded::at_block);
}

std::vector<simulation::ProcessSummary> Processes::summaries() const {
    std::vector<simulation::ProcessSummary> list;
    list.reserve(strands_.size());
    for (ProcessId id = 0; id < strands_.size(); ++id) {
        const Process& process = schedule_.process(id);
        const bool waiting = process.state == ProcessState::waiting;
        list.push_back({.name = process.name,
                        .robot = strands_[id]->robot,
                        .state = process.state == ProcessState::done ? "done"
                                 : waiting                           ? "waiting"
                                                                     : "stopped",
                        .background = process.background,
                        .start_s = process.start_s,
                        .end_s = process.time_s,
                        .idle_s = strands_[id]->idle_s});
    }
    return list;
}

}  // namespace gsim::script
