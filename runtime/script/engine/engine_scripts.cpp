// Loading of scripts by an Engine.

#include <fmt/format.h>

#include "runtime/script/engine/engine.h"

namespace gsim::script {

using text::DiagnosticKind;

Script Script::from_text(std::string text, std::string file_name, std::int64_t line_difference) {
    Script script;
    script.file_name = std::move(file_name);
    script.line_difference = line_difference;
    script.size = text.size();
    script.held_bytes = text.size();
    // Scripts are copied; their text is not.
    script.read = [held = std::make_shared<const std::string>(std::move(text))](
                      std::uint64_t begin, std::uint64_t end) { return held->substr(begin, end - begin); };
    return script;
}

// --- Scripts ---

/// Gives a file the same number for all robots.
Engine::Loaded& Engine::keep_script(lua_State* state, Script script, Control& control) {
    lua_.hold(state, script.held_bytes, kTextOfScript);
    loaded_.push_back(std::make_unique<Loaded>());
    Loaded& loaded = *loaded_.back();
    loaded.script = std::move(script);
    loaded.control = &control;
    for (const std::unique_ptr<Control>& each : controls_)
        loaded.file = each->simulator().add_file(loaded.script.file_name);
    return loaded;
}

/// Pushes a function that loads the script: registers its functions and runs its other statements.
void Engine::push_script(lua_State* state, Loaded& loaded) {
    if (loaded.script.functions.empty()) return compile(state, loaded, {0, loaded.script.size, 1});
    lua_pushlightuserdata(state, this);
    lua_pushlightuserdata(state, &loaded);
    lua_pushcclosure(state, trampoline<register_functions>, 2);
}

/// Calls what the script would call with each of its functions, such as `program(12, ...)`, with one that
/// compiles its parts.
int Engine::register_functions(lua_State* state) {
    auto& engine = bound<Engine>(state);
    auto& loaded = *static_cast<Loaded*>(lua_touserdata(state, lua_upvalueindex(2)));
    for (std::size_t i = 0; i < loaded.script.functions.size(); ++i) {
        const ScriptFunction& function = loaded.script.functions[i];
        const std::int64_t line = loaded.script.line_difference + function.chunks.front().line;
        loaded.control->push_environment(state);
        const std::uint32_t text = engine.places_.add({loaded.file, line - 1});
        load_text(state, function.head + "...)", PlaceFinder::chunk_name(text).c_str());
        lua_pushlightuserdata(state, &engine);
        lua_pushlightuserdata(state, &loaded);
        lua_pushinteger(state, static_cast<lua_Integer>(i));
        lua_pushcclosure(state, trampoline<function_body>, 3);
        lua_call(state, 1, 0);
    }
    return 0;
}

/// Returns the number of the text that begins here, for source locations.
std::uint32_t Engine::text_at(Loaded& loaded, std::uint64_t begin, std::uint32_t line) {
    const auto [found, is_new] = loaded.texts.try_emplace(begin, 0);
    if (is_new) found->second = places_.add({loaded.file, loaded.script.line_difference + line - 1});
    return found->second;
}

/// Compiles one section of a script; the function is left on the stack.
void Engine::compile(lua_State* state, Loaded& loaded, const ScriptChunk& chunk) {
    const std::uint32_t text = text_at(loaded, chunk.begin, chunk.line);
    loaded.control->push_environment(state);
    const HeldMemory copy(state, chunk.end - chunk.begin, kTextOfScript);
    const auto lua = loaded.script.read(chunk.begin, chunk.end);
    if (!lua) loaded.control->interpreter().alarm(state, DiagnosticKind::file, lua.error());
    load_text(state, *lua, PlaceFinder::chunk_name(text).c_str());
}

/// core.load_program(number or name): a function that loads the file of that program, or nil. A file is read
/// once.
int Engine::load_program(lua_State* state) {
    Engine& engine = bound<Engine>(state);
    auto& control = *static_cast<Control*>(lua_touserdata(state, lua_upvalueindex(2)));
    const std::string name =
        lua_isinteger(state, 1) != 0 ? std::to_string(lua_tointeger(state, 1)) : luaL_checkstring(state, 1);
    Loaded*& kept = engine.programs_[{&control, name}];
    if (kept == nullptr) {
        if (!control.find_program()) return 0;
        tl::expected<std::optional<Script>, std::string> script = control.find_program()(name);
        if (!script) control.interpreter().alarm(state, DiagnosticKind::program_missing, script.error());
        if (!*script) return 0;
        kept = &engine.keep_script(state, std::move(**script), control);
    }
    engine.push_script(state, *kept);
    return 1;
}

/// core.load_module(name): a function that runs the file of that module; or nil and the reason.
int Engine::load_module(lua_State* state) {
    Engine& engine = bound<Engine>(state);
    auto& control = *static_cast<Control*>(lua_touserdata(state, lua_upvalueindex(2)));
    const std::string name = luaL_checkstring(state, 1);
    tl::expected<std::optional<Script>, std::string> script;
    if (control.find_module()) script = control.find_module()(name);
    if (script && *script) {
        engine.push_script(state, engine.keep_script(state, std::move(**script), control));
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
    control.interpreter().take_program_end();
    lua_settop(state, 1);
    lua_pushlightuserdata(state, &bound<Engine>(state));
    lua_pushcclosure(state, handle_error, 1);
    lua_insert(state, 1);
    return finish_run(state, lua_pcallk(state, 0, 0, 1, 0, finish_run), 0);
}

/// Passes an error on as the end of the run, with what handle_error has recorded of it.
int Engine::finish_run(lua_State* state, int status, lua_KContext) {
    if (status == LUA_OK || status == LUA_YIELD) return 0;
    LuaState& lua = LuaState::of(state);
    auto& control = *static_cast<Control*>(lua_touserdata(state, lua_upvalueindex(2)));
    const bool program_end = control.interpreter().take_program_end();
    if (status == LUA_ERRRUN && LuaState::is_stop(state, -1) && program_end &&
        lua.ended() == LuaState::Ended::no)
        return 0;
    Engine& engine = bound<Engine>(state);
    engine.judge(status, state, control);
    LuaState::raise_stop(state);
}

}  // namespace gsim::script
