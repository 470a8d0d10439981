#include "runtime/script/engine/engine.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "runtime/script/bindings/bindings.h"
#include "runtime/script/lua/data_tables.h"
#include "runtime/script/lua/sandbox.h"

namespace gsim::script {

using text::DiagnosticKind;

using simulation::SourceLocation;

namespace {

std::vector<Robot> single_robot(simulation::Simulator& simulator, const Engine::Options& options) {
    std::vector<Robot> robots;
    robots.push_back({.name = "",
                      .simulator = simulator,
                      .dialect = options.dialect,
                      .codes = options.codes,
                      .unit_mm = options.unit_mm,
                      .data = options.data,
                      .find_program = options.find_program,
                      .find_module = options.find_module});
    return robots;
}

std::vector<std::unique_ptr<RobotController>> make_controllers(std::vector<Robot> robots,
                                                               SourceLocator& locations) {
    std::vector<std::unique_ptr<RobotController>> controllers;
    controllers.reserve(robots.size());
    for (Robot& robot : robots)
        controllers.push_back(std::make_unique<RobotController>(std::move(robot), locations));
    return controllers;
}

std::vector<RobotController*> pointers(const std::vector<std::unique_ptr<RobotController>>& controllers) {
    std::vector<RobotController*> list;
    list.reserve(controllers.size());
    for (const std::unique_ptr<RobotController>& controller : controllers) list.push_back(controller.get());
    return list;
}

}  // namespace

Engine::Engine(simulation::Simulator& simulator, const Options& options)
    : Engine(single_robot(simulator, options), {}, options) {}

Engine::Engine(std::vector<Robot> robots, std::vector<process::Conveyor> conveyors, Options options)
    : options_(std::move(options)),
      controllers_(make_controllers(std::move(robots), source_locator_)),
      lua_(options_.limits),
      processes_(lua_, source_locator_, pointers(controllers_), std::move(conveyors)) {
    processes_.zones().set_zones(options_.zones);
    if (options_.multi_robot_monitor != nullptr)
        processes_.set_multi_robot_monitor(*options_.multi_robot_monitor);
    lua_.on_last_step([this](lua_State* state) { last_step_location_ = source_locator_.current(state, 0); });
    const int status = call_protected([](Engine& engine) { engine.open_controllers(); });
    if (!process_result(status, lua_.get(), *controllers_.front())) {
        throw std::runtime_error("the Lua library cannot be loaded: " +
                                 controllers_.front()->simulator().outcome().alarm()->message);
    }
}

/// Runs `work` with errors of Lua caught; the status is that of lua_pcall.
int Engine::call_protected(void (*work)(Engine&)) {
    lua_State* state = lua_.get();
    work_ = work;
    lua_settop(state, 0);
    lua_pushlightuserdata(state, this);
    lua_pushcclosure(state, handle_error, 1);
    lua_pushlightuserdata(state, this);
    lua_pushcclosure(state, trampoline<call_work_function>, 1);
    return lua_pcall(state, 0, 0, 1);
}

int Engine::call_work_function(lua_State* state) {
    auto& engine = bound<Engine>(state);
    engine.work_(engine);
    return 0;
}

void Engine::open_controllers() {
    lua_State* state = lua_.get();
    make_nil_vacant(state);
    const RobotController::ProgramOptions switches{options_.block_delete, options_.optional_stop,
                                                   options_.passes};
    lua_gc(state, LUA_GCSTOP);  // nearly all that the library makes stays
    for (const std::unique_ptr<RobotController>& controller : controllers_) {
        controller->open(state, options_.library, switches,
                         [this](lua_State* at, RobotController& of) { add_core_functions(at, of); });
    }
    lua_gc(state, LUA_GCRESTART);
}

/// Adds functions that the library of a controller needs from the engine.
void Engine::add_core_functions(lua_State* state, RobotController& controller) {
    const auto set = [&](const char* name, lua_CFunction function) {
        lua_pushlightuserdata(state, this);
        lua_pushlightuserdata(state, &controller);
        lua_pushcclosure(state, function, 2);
        lua_setfield(state, -2, name);
    };
    set("load_program", trampoline<load_program>);
    set("load_module", trampoline<load_module>);
    set("run_to_end", trampoline<run_to_end>);
    add_processes(state, processes_, controller);
}

// --- Running ---

bool Engine::run(Script script) {
    lua_.set_time_limit(options_.cpu);
    pending_.push_back(std::move(script));
    if (options_.setup) pending_.push_back(std::move(*options_.setup));
    return process_outcome(call_protected([](Engine& engine) { engine.run_processes(); }));
}

/// Runs the main process, which is the library's; next_script passes the scripts to it.
void Engine::run_processes() {
    lua_State* state = lua_.get();
    controllers_.front()->push_library(state, "main_process");
    lua_pushlightuserdata(state, this);
    lua_pushcclosure(state, trampoline<next_script>, 1);
    lua_call(state, 1, 1);
    outcome_ = processes_.run(state);
}

/// Returns the next script, as a function that registers its functions and runs its other statements;
/// otherwise no value.
int Engine::next_script(lua_State* state) {
    auto& engine = bound<Engine>(state);
    if (engine.pending_.empty()) return 0;
    Script script = std::move(engine.pending_.back());
    engine.pending_.pop_back();
    engine.push_script(state, engine.add_script(state, std::move(script), *engine.controllers_.front()));
    return 1;
}

Result<std::map<int, double>> Engine::permanent_variables() {
    permanent_variables_.clear();
    return read_retained([](Engine& engine) { engine.read_permanent(); }).map([this] {
        return permanent_variables_;
    });
}

Result<machine::MachineData> Engine::machine_data() {
    stored_data_ = options_.data;
    return read_retained([](Engine& engine) { engine.read_stored(); }).map([this] { return stored_data_; });
}

/// Restarts the steps and ends the time limit, because a run that has used them up has none left for this.
Result<void> Engine::read_retained(void (*read)(Engine&)) {
    lua_.restart_steps();
    lua_.set_time_limit(nullptr);
    error_.clear();
    if (call_protected(read) == LUA_OK) return {};
    return Unexpected(fmt::format("the stored data of the controller cannot be read: {}",
                                  error_.empty() ? "the script has run out of memory" : error_));
}

void Engine::read_permanent() {
    lua_State* state = lua_.get();
    controllers_.front()->push_library(state, "permanent_variables");
    lua_call(state, 0, 1);
    lua_pushnil(state);
    while (lua_next(state, -2) != 0) {
        permanent_variables_[static_cast<int>(luaL_checkinteger(state, -2))] = luaL_checknumber(state, -1);
        lua_pop(state, 1);
    }
    lua_pop(state, 1);
}

void Engine::report(simulation::Report& report) const {
    if (!processes_.several() && controllers_.size() == 1) return;
    report.concurrency.processes = processes_.summaries();
    report.concurrency.signals = processes_.signals().board().changes();
    if (const std::uint64_t dropped = processes_.signals().board().dropped(); dropped > 0)
        report.messages.warnings.push_back(
            fmt::format("{} more signal changes are not listed in the report", dropped));
    report.concurrency.zone_uses = processes_.zones().shared_zones().uses();
    if (const std::uint64_t dropped = processes_.zones().shared_zones().dropped(); dropped > 0)
        report.messages.warnings.push_back(
            fmt::format("{} more zone uses are not listed in the report", dropped));
}

void Engine::read_stored() {
    lua_State* state = lua_.get();
    controllers_.front()->push_library(state, "stored_data");
    lua_call(state, 0, 1);
    read_data_tables(state, stored_data_);
    lua_pop(state, 1);
}

// --- Errors ---

/// Records the error and its location, while the stack still exists. The error is at `index`, and was raised
/// `level` levels up.
void Engine::record_error(lua_State* state, int index, int level) {
    const char* text = lua_tostring(state, index);
    error_ = text != nullptr
                 ? text
                 : fmt::format("an error that is not a string but a {}", luaL_typename(state, index));
    error_location_ = source_locator_.strip(error_);
    if (error_location_.line == 0) error_location_ = source_locator_.current(state, level);
}

int Engine::handle_error(lua_State* state) {
    if (!LuaState::is_stop(state, 1)) bound<Engine>(state).record_error(state, 1, 1);
    return 1;
}

/// Applies the end of the processes to the run.
bool Engine::process_outcome(int status) {
    RobotController& first = *controllers_.front();
    if (status != LUA_OK) return process_result(status, lua_.get(), first);
    Processes::Outcome& outcome = *outcome_;
    if (outcome.end == Processes::RunEnd::error) {
        if (!LuaState::is_stop(outcome.error_thread, -1)) record_error(outcome.error_thread, -1, 0);
        process_result(outcome.status, outcome.error_thread, *outcome.controller);
    }
    if (outcome.end == Processes::RunEnd::deadlock)
        outcome.controller->simulator().outcome().fail(DiagnosticKind::script, std::move(outcome.message),
                                                       outcome.location);
    return std::none_of(controllers_.begin(), controllers_.end(),
                        [](const std::unique_ptr<RobotController>& controller) {
                            return controller->simulator().outcome().alarm().has_value();
                        });
}

/// Applies the end of a protected call to the run; the error is on top of the stack.
bool Engine::process_result(int status, lua_State* state, RobotController& controller) {
    simulation::Simulator& simulator = controller.simulator();
    if (status == LUA_OK) return !simulator.outcome().alarm();
    const SourceLocation location = controller.interpreter().location();
    if (status == LUA_ERRMEM || lua_.ended() == LuaState::StopReason::memory) {
        return simulator.outcome().stop(DiagnosticKind::run_limit, lua_.memory().error(), location);
    }
    if (lua_.ended() == LuaState::StopReason::steps) {
        return simulator.outcome().stop(
            DiagnosticKind::run_limit,
            fmt::format(
                "{} steps of the script without a motion or a dwell (--max-steps): is this an endless loop?",
                lua_.limits().steps),
            last_step_location_.line > 0 ? last_step_location_ : location);
    }
    if (lua_.ended() == LuaState::StopReason::cpu)
        return simulator.outcome().has_cpu_time(last_step_location_.line > 0 ? last_step_location_
                                                                             : location);
    if (LuaState::is_stop(state, -1)) return !simulator.outcome().alarm();
    return simulator.outcome().fail(
        DiagnosticKind::script, error_.empty() ? "an error in the error handler" : error_, error_location_);
}

}  // namespace gsim::script
