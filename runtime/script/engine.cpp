#include "runtime/script/engine.h"

#include <stdexcept>

#include <fmt/format.h>

#include "runtime/machine/homes.h"
#include "runtime/script/bindings.h"
#include "runtime/script/data_tables.h"
#include "runtime/script/sandbox.h"

namespace gsim::script {

using simulation::Place;

namespace {

void push_reference(lua_State* state, int reference) {
    lua_rawgeti(state, LUA_REGISTRYINDEX, reference);
}

/// Compiles a text and gives it the environment at `environment`; leaves the function on the stack, or
/// raises.
void load_text(lua_State* state, const std::string& text, const char* name, int environment) {
    if (luaL_loadbufferx(state, text.data(), text.size(), name, "t") != LUA_OK) lua_error(state);
    push_reference(state, environment);
    lua_setupvalue(state, -2, 1);
}

void set_number(lua_State* state, const char* name, double value) {
    lua_pushnumber(state, value);
    lua_setfield(state, -2, name);
}

/// core.corner_override.percent, .before_mm, .after_mm and .angle_deg; the table of core is on top of the
/// stack.
void set_corner_override(lua_State* state, const rrs::ControllerRules& rules) {
    lua_createtable(state, 0, 4);
    set_number(state, "percent", rules.corner_override_percent);
    set_number(state, "before_mm", rules.corner_override_before_mm);
    set_number(state, "after_mm", rules.corner_override_after_mm);
    set_number(state, "angle_deg", rules.corner_override_angle_deg);
    lua_setfield(state, -2, "corner_override");
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

Engine::Engine(simulation::Simulator& simulator, Options options)
    : simulator_(simulator),
      options_(std::move(options)),
      controller_(simulator, places_),
      lua_(options_.limits) {
    simulator_.watch_zones(options_.data);
    lua_.on_last_step([this](lua_State* state) { controller_.locate(state, 0); });
    if (!judge(call_protected([](Engine& engine) {
            engine.open_environment();
            engine.call_include("init.lua");
        }))) {
        throw std::runtime_error("the library in Lua cannot be loaded: " + simulator_.alarm()->message);
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

/// What a script sees (the environment) and what the library's files see: the same safe functions, each in
/// tables of their own, so that a script that changes its own harms no word; and the core.
void Engine::open_environment() {
    lua_State* state = lua_.get();
    make_nil_vacant(state);
    push_safe_library(state);
    const int environment = lua_gettop(state);
    lua_newtable(state);
    add_rrs(state, controller_);
    lua_setfield(state, environment, "rrs");
    set_require(state, environment);
    push_safe_library(state);
    const int library = lua_gettop(state);
    for (const char* name : {"setmetatable", "rawget", "rawset"}) {
        lua_getglobal(state, name);
        lua_setfield(state, library, name);
    }
    lua_newtable(state);
    add_core(state, controller_);
    add_motion_words(state, controller_);
    add_arc_words(state, controller_);
    add_moves(state, controller_);
    add_frames(state, controller_);
    add_poses(state, controller_);
    add_zones(state, controller_);
    set_function<load_program>(state, "load_program", this);
    set_options(state);
    machine::MachineData tables = options_.data;
    tables.homes = machine::further_homes(simulator_.machine(), tables.homes);
    set_data_tables(state, tables);
    lua_setfield(state, library, "core");
    lua_pushvalue(state, environment);
    lua_setfield(state, library, "env");
    lua_pushvalue(state, library);
    set_function<include_file>(state, "include", this);
    lua_pop(state, 1);
    library_ = luaL_ref(state, LUA_REGISTRYINDEX);
    environment_ = luaL_ref(state, LUA_REGISTRYINDEX);
}

void Engine::set_require(lua_State* state, int environment) {
    lua_pushlightuserdata(state, this);
    lua_pushvalue(state, environment);
    lua_pushcclosure(state, trampoline<require_gsim>, 2);
    lua_setfield(state, environment, "require");
}

/// require "gsim" or "gsim.rs274ngc": the environment, of the run's dialect; there is nothing else to
/// require.
int Engine::require_gsim(lua_State* state) {
    const std::string& dialect = bound<Engine>(state).options_.dialect;
    const std::string_view name = luaL_checkstring(state, 1);
    if (name != "gsim" && name != "gsim.rs274ngc") {
        return luaL_error(state, "require finds \"gsim\" and \"gsim.rs274ngc\" alone, not \"%s\"",
                          lua_tostring(state, 1));
    }
    if ((name == "gsim") != (dialect == "ab9")) {
        return luaL_error(state, "this run is of the dialect %s, and \"%s\" is another one", dialect.c_str(),
                          lua_tostring(state, 1));
    }
    lua_pushvalue(state, lua_upvalueindex(2));
    return 1;
}

/// Fields of `core` that the command line and the machine decide; the table is on top of the stack.
void Engine::set_options(lua_State* state) {
    lua_pushlstring(state, options_.dialect.data(), options_.dialect.size());
    lua_setfield(state, -2, "dialect");
    lua_pushboolean(state, static_cast<int>(options_.block_delete));
    lua_setfield(state, -2, "block_delete");
    lua_pushboolean(state, static_cast<int>(options_.optional_stop));
    lua_setfield(state, -2, "optional_stop");
    const bool stops = simulator_.machine().controller.planner == rrs::PlannerKind::rest_to_rest;
    lua_pushboolean(state, static_cast<int>(stops));
    lua_setfield(state, -2, "stops_at_each_move");
    set_corner_override(state, simulator_.machine().controller);
}

void Engine::call_include(const std::string& file_name) {
    lua_State* state = lua_.get();
    const tl::expected<std::string, std::string> text = options_.library.read(file_name);
    if (!text) throw std::runtime_error(text.error());
    load_text(state, *text, ("=lua_lib/" + file_name).c_str(), library_);
    lua_call(state, 0, 0);
}

/// include "file": runs another file of the library.
int Engine::include_file(lua_State* state) {
    bound<Engine>(state).call_include(std::string(luaL_checkstring(state, 1)) + ".lua");
    return 0;
}

bool Engine::run(Script script) {
    pending_ = std::move(script);
    return judge(call_protected([](Engine& engine) {
        if (engine.options_.setup) engine.load_script(std::move(*engine.options_.setup));
        engine.load_script(std::move(engine.pending_));
        engine.call_library("run_first");
    }));
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
    push_reference(state, library_);
    lua_getfield(state, -1, "permanent_variables");
    lua_call(state, 0, 1);
    lua_pushnil(state);
    while (lua_next(state, -2) != 0) {
        permanent_[static_cast<int>(luaL_checkinteger(state, -2))] = luaL_checknumber(state, -1);
        lua_pop(state, 1);
    }
    lua_pop(state, 2);
}

void Engine::read_stored() {
    lua_State* state = lua_.get();
    push_reference(state, library_);
    lua_getfield(state, -1, "stored_data");
    lua_call(state, 0, 1);
    read_data_tables(state, stored_);
    lua_pop(state, 2);
}

void Engine::call_library(const char* function) {
    lua_State* state = lua_.get();
    push_reference(state, library_);
    lua_getfield(state, -1, function);
    lua_call(state, 0, 0);
    lua_pop(state, 1);
}

/// Loads a script: its functions are registered, its other statements run.
void Engine::load_script(Script script) {
    lua_State* state = lua_.get();
    loaded_.push_back(std::make_unique<Loaded>());
    Loaded& loaded = *loaded_.back();
    loaded.script = std::move(script);
    loaded.file = simulator_.add_file(loaded.script.file_name);
    if (loaded.script.functions.empty()) {
        compile(loaded, {0, loaded.script.size, 1});
        lua_call(state, 0, 0);
        return;
    }
    for (std::size_t i = 0; i < loaded.script.functions.size(); ++i) register_function(loaded, i);
}

/// Calls what the script would call with this function, `program(12, ...)` say, with one that compiles its
/// pieces.
void Engine::register_function(Loaded& loaded, std::size_t index) {
    lua_State* state = lua_.get();
    const ScriptFunction& function = loaded.script.functions[index];
    const std::int64_t line = loaded.script.line_difference + function.chunks.front().line;
    load_text(state, function.head + "...)", places_.add({loaded.file, line - 1}).c_str(), environment_);
    lua_pushlightuserdata(state, this);
    lua_pushlightuserdata(state, &loaded);
    lua_pushinteger(state, static_cast<lua_Integer>(index));
    lua_pushcclosure(state, trampoline<function_body>, 3);
    lua_call(state, 1, 0);
}

/// Compiles one stretch of a script; the function is left on the stack.
void Engine::compile(Loaded& loaded, const ScriptChunk& chunk) {
    std::string& name = loaded.chunk_names[chunk.begin];
    if (name.empty()) name = places_.add({loaded.file, loaded.script.line_difference + chunk.line - 1});
    load_text(lua_.get(), loaded.script.read(chunk.begin, chunk.end), name.c_str(), environment_);
}

/// The body of a function that runs in pieces; upvalues: engine, script, number of the function in it.
int Engine::function_body(lua_State* state) {
    Engine& engine = bound<Engine>(state);
    auto& loaded = *static_cast<Loaded*>(lua_touserdata(state, lua_upvalueindex(2)));
    const auto index = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3)));
    const std::vector<ScriptChunk>& chunks = loaded.script.functions[index].chunks;
    if (chunks.size() == 1) {  // a subprogram, likely called again: compiled once
        const auto [place, is_new] = loaded.compiled.try_emplace(index, LUA_NOREF);
        if (is_new) {
            engine.compile(loaded, chunks.front());
            place->second = luaL_ref(state, LUA_REGISTRYINDEX);
        }
        push_reference(state, place->second);
        lua_call(state, 0, 1);
        return 1;
    }
    for (const ScriptChunk& chunk : chunks) {
        engine.compile(loaded, chunk);
        lua_call(state, 0, 1);
        if (!lua_isnil(state, -1)) return 1;
        lua_pop(state, 1);
        if (engine.options_.progress) engine.options_.progress(chunk.end, loaded.script.size);
    }
    return 0;
}

/// core.load_program(number or name): true where a file of that program was found and loaded.
int Engine::load_program(lua_State* state) {
    Engine& engine = bound<Engine>(state);
    const std::string name =
        lua_isinteger(state, 1) != 0 ? std::to_string(lua_tointeger(state, 1)) : luaL_checkstring(state, 1);
    if (!engine.options_.find_program) return 0;
    tl::expected<std::optional<Script>, std::string> script = engine.options_.find_program(name);
    if (!script) engine.controller_.alarm(state, script.error());
    if (!*script) return 0;
    engine.load_script(std::move(**script));
    lua_pushboolean(state, 1);
    return 1;
}

/// Notes what went wrong and where, while the stack still stands.
int Engine::handle_error(lua_State* state) {
    Engine& engine = bound<Engine>(state);
    if (LuaState::is_stop(state, 1)) return 1;
    const char* text = lua_tostring(state, 1);
    engine.error_ =
        text != nullptr ? text : fmt::format("an error that is no text but a {}", luaL_typename(state, 1));
    engine.error_place_ = engine.places_.strip(engine.error_);
    if (engine.error_place_.line == 0) engine.error_place_ = engine.places_.current(state);
    return 1;
}

/// What the end of a protected call means for the run.
bool Engine::judge(int status) {
    lua_State* state = lua_.get();
    if (status == LUA_OK) return !simulator_.alarm();
    const Place place = controller_.place();
    if (status == LUA_ERRMEM || lua_.ended() == LuaState::Ended::memory) {
        return simulator_.stop(fmt::format("the script needs more than {} MB of memory (--memory)",
                                           lua_.limits().memory_bytes >> 20U),
                               place);
    }
    if (lua_.ended() == LuaState::Ended::steps) {
        return simulator_.stop(
            fmt::format(
                "{} steps of the script without a motion or a dwell (--max-steps): is this an endless loop?",
                lua_.limits().steps),
            place);
    }
    if (LuaState::is_stop(state, -1)) return !simulator_.alarm();
    return simulator_.fail(error_.empty() ? "an error in the handling of an error" : error_, error_place_);
}

}  // namespace gsim::script
