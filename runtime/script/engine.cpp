#include "runtime/script/engine.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "runtime/script/bindings.h"
#include "runtime/script/data_tables.h"
#include "runtime/script/sandbox.h"

namespace gsim::script {

using text::DiagnosticKind;

using simulation::Place;

namespace {

std::vector<Robot> only_robot(simulation::Simulator& simulator, const Engine::Options& options) {
    std::vector<Robot> robots;
    robots.push_back({.name = "",
                      .simulator = simulator,
                      .dialect = options.dialect,
                      .unit_mm = options.unit_mm,
                      .data = options.data,
                      .find_program = options.find_program,
                      .find_module = options.find_module});
    return robots;
}

std::vector<std::unique_ptr<Control>> make_controls(std::vector<Robot> robots, PlaceFinder& places) {
    std::vector<std::unique_ptr<Control>> controls;
    controls.reserve(robots.size());
    for (Robot& robot : robots) controls.push_back(std::make_unique<Control>(std::move(robot), places));
    return controls;
}

std::vector<Control*> pointers(const std::vector<std::unique_ptr<Control>>& controls) {
    std::vector<Control*> list;
    list.reserve(controls.size());
    for (const std::unique_ptr<Control>& control : controls) list.push_back(control.get());
    return list;
}

}  // namespace

Script Script::from_text(std::string text, std::string file_name, std::int64_t line_difference) {
    Script script;
    script.file_name = std::move(file_name);
    script.line_difference = line_difference;
    script.size = text.size();
    script.read = [held = std::move(text)](std::uint64_t begin, std::uint64_t end) {
        return held.substr(begin, end - begin);
    };
    return script;
}

Engine::Engine(simulation::Simulator& simulator, const Options& options)
    : Engine(only_robot(simulator, options), {}, options) {}

Engine::Engine(std::vector<Robot> robots, std::vector<process::Conveyor> conveyors, Options options)
    : options_(std::move(options)),
      controls_(make_controls(std::move(robots), places_)),
      lua_(options_.limits),
      processes_(lua_, places_, pointers(controls_), std::move(conveyors)) {
    lua_.on_last_step([this](lua_State* state) { last_step_place_ = places_.current(state, 0); });
    const int status = call_protected([](Engine& engine) { engine.open_controls(); });
    if (!judge(status, lua_.get(), *controls_.front())) {
        throw std::runtime_error("the library in Lua cannot be loaded: " +
                                 controls_.front()->simulator().alarm()->message);
    }
}

/// Runs `work` where errors of Lua are caught; the status is that of lua_pcall.
int Engine::call_protected(void (*work)(Engine&)) {
    lua_State* state = lua_.get();
    work_ = work;
    lua_settop(state, 0);
    lua_pushlightuserdata(state, this);
    lua_pushcclosure(state, handle_error, 1);
    lua_pushlightuserdata(state, this);
    lua_pushcclosure(state, trampoline<do_work>, 1);
    return lua_pcall(state, 0, 0, 1);
}

int Engine::do_work(lua_State* state) {
    auto& engine = bound<Engine>(state);
    engine.work_(engine);
    return 0;
}

void Engine::open_controls() {
    lua_State* state = lua_.get();
    make_nil_vacant(state);
    const Control::Switches switches{options_.block_delete, options_.optional_stop, options_.passes};
    for (const std::unique_ptr<Control>& control : controls_) {
        control->open(state, options_.library, switches,
                      [this](lua_State* at, Control& of) { add_core_functions(at, of); });
    }
}

/// What the library of a control asks of the engine.
void Engine::add_core_functions(lua_State* state, Control& control) {
    const auto set = [&](const char* name, lua_CFunction function) {
        lua_pushlightuserdata(state, this);
        lua_pushlightuserdata(state, &control);
        lua_pushcclosure(state, function, 2);
        lua_setfield(state, -2, name);
    };
    set("load_program", trampoline<load_program>);
    set("load_module", trampoline<load_module>);
    set("run_to_end", trampoline<run_to_end>);
    add_processes(state, processes_, control);
}

// --- Running ---

bool Engine::run(Script script) {
    pending_.push_back(std::move(script));
    if (options_.setup) pending_.push_back(std::move(*options_.setup));
    return judge_processes(call_protected([](Engine& engine) { engine.run_processes(); }));
}

/// The main process is the library's, to which next_script gives the scripts.
void Engine::run_processes() {
    lua_State* state = lua_.get();
    controls_.front()->push_library(state, "main_process");
    lua_pushlightuserdata(state, this);
    lua_pushcclosure(state, trampoline<next_script>, 1);
    lua_call(state, 1, 1);
    outcome_ = processes_.run(state);
}

/// The next script, as a function that registers its functions and runs its other statements; else nothing.
int Engine::next_script(lua_State* state) {
    auto& engine = bound<Engine>(state);
    if (engine.pending_.empty()) return 0;
    Script script = std::move(engine.pending_.back());
    engine.pending_.pop_back();
    engine.push_script(state, std::move(script), *engine.controls_.front());
    return 1;
}

tl::expected<std::map<int, double>, std::string> Engine::permanent_variables() {
    permanent_.clear();
    return read_kept([](Engine& engine) { engine.read_permanent(); }).map([this] { return permanent_; });
}

tl::expected<machine::MachineData, std::string> Engine::machine_data() {
    stored_ = options_.data;
    return read_kept([](Engine& engine) { engine.read_stored(); }).map([this] { return stored_; });
}

/// A run that has used up its steps has none left for this: they count anew.
tl::expected<void, std::string> Engine::read_kept(void (*read)(Engine&)) {
    lua_.restart_steps();
    error_.clear();
    if (call_protected(read) == LUA_OK) return {};
    return tl::unexpected(fmt::format("what the control keeps cannot be read: {}",
                                      error_.empty() ? "the script has used up its memory" : error_));
}

void Engine::read_permanent() {
    lua_State* state = lua_.get();
    controls_.front()->push_library(state, "permanent_variables");
    lua_call(state, 0, 1);
    lua_pushnil(state);
    while (lua_next(state, -2) != 0) {
        permanent_[static_cast<int>(luaL_checkinteger(state, -2))] = luaL_checknumber(state, -1);
        lua_pop(state, 1);
    }
    lua_pop(state, 1);
}

void Engine::report(simulation::Report& report) const {
    if (!processes_.several() && controls_.size() == 1) return;
    report.processes = processes_.summaries();
    report.signals = processes_.signals().changes();
    if (const std::uint64_t dropped = processes_.signals().dropped(); dropped > 0)
        report.warnings.push_back(
            fmt::format("{} more changes of signals than the report lists were left out", dropped));
}

void Engine::read_stored() {
    lua_State* state = lua_.get();
    controls_.front()->push_library(state, "stored_data");
    lua_call(state, 0, 1);
    read_data_tables(state, stored_);
    lua_pop(state, 1);
}

// --- Scripts ---

/// Pushes what loads the script: its functions are registered, its other statements run. The place of a file
/// is the same for all robots.
void Engine::push_script(lua_State* state, Script script, Control& control) {
    loaded_.push_back(std::make_unique<Loaded>());
    Loaded& loaded = *loaded_.back();
    loaded.script = std::move(script);
    loaded.control = &control;
    for (const std::unique_ptr<Control>& each : controls_)
        loaded.file = each->simulator().add_file(loaded.script.file_name);
    if (loaded.script.functions.empty()) return compile(state, loaded, {0, loaded.script.size, 1});
    lua_pushlightuserdata(state, this);
    lua_pushlightuserdata(state, &loaded);
    lua_pushcclosure(state, trampoline<register_functions>, 2);
}

/// Calls what the script would call with each of its functions, `program(12, ...)` say, with one that
/// compiles its pieces.
int Engine::register_functions(lua_State* state) {
    auto& engine = bound<Engine>(state);
    auto& loaded = *static_cast<Loaded*>(lua_touserdata(state, lua_upvalueindex(2)));
    for (std::size_t i = 0; i < loaded.script.functions.size(); ++i) {
        const ScriptFunction& function = loaded.script.functions[i];
        const std::int64_t line = loaded.script.line_difference + function.chunks.front().line;
        loaded.control->push_environment(state);
        load_text(state, function.head + "...)", engine.places_.add({loaded.file, line - 1}).c_str());
        lua_pushlightuserdata(state, &engine);
        lua_pushlightuserdata(state, &loaded);
        lua_pushinteger(state, static_cast<lua_Integer>(i));
        lua_pushcclosure(state, trampoline<function_body>, 3);
        lua_call(state, 1, 0);
    }
    return 0;
}

/// Compiles one stretch of a script; the function is left on the stack.
void Engine::compile(lua_State* state, Loaded& loaded, const ScriptChunk& chunk) {
    std::string& name = loaded.chunk_names[chunk.begin];
    if (name.empty()) name = places_.add({loaded.file, loaded.script.line_difference + chunk.line - 1});
    loaded.control->push_environment(state);
    load_text(state, loaded.script.read(chunk.begin, chunk.end), name.c_str());
}

/// The body of a function that runs in pieces; upvalues: engine, script, number of the function in it.
int Engine::function_body(lua_State* state) {
    Engine& engine = bound<Engine>(state);
    auto& loaded = *static_cast<Loaded*>(lua_touserdata(state, lua_upvalueindex(2)));
    const auto index = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3)));
    const std::vector<ScriptChunk>& chunks = loaded.script.functions[index].chunks;
    if (chunks.size() > 1) return engine.run_chunks(state, 0);
    const auto [place, is_new] = loaded.compiled.try_emplace(index, LUA_NOREF);
    if (is_new) {  // a subprogram, likely called again: compiled once
        engine.compile(state, loaded, chunks.front());
        place->second = luaL_ref(state, LUA_REGISTRYINDEX);
    }
    lua_rawgeti(state, LUA_REGISTRYINDEX, place->second);
    lua_callk(state, 0, 1, static_cast<lua_KContext>(chunks.size()), go_on_with_body);
    return 1;
}

/// Goes on with piece `next` of function_body(), whose upvalues the state has.
int Engine::run_chunks(lua_State* state, std::size_t next) {
    auto& loaded = *static_cast<Loaded*>(lua_touserdata(state, lua_upvalueindex(2)));
    const auto index = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3)));
    const std::vector<ScriptChunk>& chunks = loaded.script.functions[index].chunks;
    for (; next < chunks.size(); ++next) {
        compile(state, loaded, chunks[next]);
        lua_callk(state, 0, 1, static_cast<lua_KContext>(next + 1), go_on_with_body);
        if (!lua_isnil(state, -1)) return 1;
        lua_pop(state, 1);
        if (options_.progress) options_.progress(chunks[next].end, loaded.script.size);
    }
    return 0;
}

/// Behind a piece that has waited for other processes; its result is on top of the stack.
int Engine::go_on_with_body(lua_State* state, int, lua_KContext next) {
    if (!lua_isnil(state, -1)) return 1;
    lua_pop(state, 1);
    try {
        return bound<Engine>(state).run_chunks(state, static_cast<std::size_t>(next));
    } catch (const std::exception& error) {
        lua_pushstring(state, error.what());
    }
    return lua_error(state);
}

/// core.load_program(number or name): what loads the file of that program, or nil.
int Engine::load_program(lua_State* state) {
    Engine& engine = bound<Engine>(state);
    auto& control = *static_cast<Control*>(lua_touserdata(state, lua_upvalueindex(2)));
    const std::string name =
        lua_isinteger(state, 1) != 0 ? std::to_string(lua_tointeger(state, 1)) : luaL_checkstring(state, 1);
    if (!control.find_program()) return 0;
    tl::expected<std::optional<Script>, std::string> script = control.find_program()(name);
    if (!script) control.controller().alarm(state, DiagnosticKind::program_missing, script.error());
    if (!*script) return 0;
    engine.push_script(state, std::move(**script), control);
    return 1;
}

/// core.load_module(name): what runs the file of that module; or nil and why there is none.
int Engine::load_module(lua_State* state) {
    Engine& engine = bound<Engine>(state);
    auto& control = *static_cast<Control*>(lua_touserdata(state, lua_upvalueindex(2)));
    const std::string name = luaL_checkstring(state, 1);
    tl::expected<std::optional<Script>, std::string> script;
    if (control.find_module()) script = control.find_module()(name);
    if (script && *script) {
        engine.push_script(state, std::move(**script), control);
        return 1;
    }
    const std::string reason = script ? "this run has no folder of modules" : script.error();
    lua_pushnil(state);
    lua_pushlstring(state, reason.data(), reason.size());
    return 2;
}

/// core.run_to_end(f): f(), up to the end of a program within.
int Engine::run_to_end(lua_State* state) {
    auto& control = *static_cast<Control*>(lua_touserdata(state, lua_upvalueindex(2)));
    control.controller().take_program_end();
    lua_settop(state, 1);
    lua_pushlightuserdata(state, &bound<Engine>(state));
    lua_pushcclosure(state, handle_error, 1);
    lua_insert(state, 1);
    return finish_run(state, lua_pcallk(state, 0, 0, 1, 0, finish_run), 0);
}

/// An error goes on as the end of the run, with what handle_error has noted of it.
int Engine::finish_run(lua_State* state, int status, lua_KContext) {
    if (status == LUA_OK || status == LUA_YIELD) return 0;
    LuaState& lua = LuaState::of(state);
    auto& control = *static_cast<Control*>(lua_touserdata(state, lua_upvalueindex(2)));
    const bool program_end = control.controller().take_program_end();
    if (status == LUA_ERRRUN && LuaState::is_stop(state, -1) && program_end &&
        lua.ended() == LuaState::Ended::no)
        return 0;
    Engine& engine = bound<Engine>(state);
    engine.judge(status, state, control);
    LuaState::raise_stop(state);
}

// --- Errors ---

/// Notes what went wrong and where, while the stack still stands. The error is at `index`, and `level` levels
/// up is what raised it.
void Engine::note_error(lua_State* state, int index, int level) {
    const char* text = lua_tostring(state, index);
    error_ = text != nullptr ? text
                             : fmt::format("an error that is no text but a {}", luaL_typename(state, index));
    error_place_ = places_.strip(error_);
    if (error_place_.line == 0) error_place_ = places_.current(state, level);
}

int Engine::handle_error(lua_State* state) {
    if (!LuaState::is_stop(state, 1)) bound<Engine>(state).note_error(state, 1, 1);
    return 1;
}

/// What the end of the processes means for the run.
bool Engine::judge_processes(int status) {
    Control& first = *controls_.front();
    if (status != LUA_OK) return judge(status, lua_.get(), first);
    Processes::Outcome& outcome = *outcome_;
    if (outcome.end == Processes::End::error) {
        if (!LuaState::is_stop(outcome.fault, -1)) note_error(outcome.fault, -1, 0);
        judge(outcome.status, outcome.fault, *outcome.control);
    }
    if (outcome.end == Processes::End::deadlock)
        outcome.control->simulator().fail(DiagnosticKind::script, std::move(outcome.message), outcome.place);
    return std::none_of(controls_.begin(), controls_.end(), [](const std::unique_ptr<Control>& control) {
        return control->simulator().alarm().has_value();
    });
}

/// What the end of a protected call means for the run; the error is on top of the stack.
bool Engine::judge(int status, lua_State* state, Control& control) {
    simulation::Simulator& simulator = control.simulator();
    if (status == LUA_OK) return !simulator.alarm();
    const Place place = control.controller().place();
    if (status == LUA_ERRMEM || lua_.ended() == LuaState::Ended::memory) {
        return simulator.stop(DiagnosticKind::run_limit,
                              fmt::format("the script needs more than {} MB of memory (--memory)",
                                          lua_.limits().memory_bytes >> 20U),
                              place);
    }
    if (lua_.ended() == LuaState::Ended::steps) {
        return simulator.stop(
            DiagnosticKind::run_limit,
            fmt::format(
                "{} steps of the script without a motion or a dwell (--max-steps): is this an endless loop?",
                lua_.limits().steps),
            last_step_place_.line > 0 ? last_step_place_ : place);
    }
    if (LuaState::is_stop(state, -1)) return !simulator.alarm();
    return simulator.fail(DiagnosticKind::script,
                          error_.empty() ? "an error in the handling of an error" : error_, error_place_);
}

}  // namespace gsim::script
