// Loading of scripts by an Engine.

#include <fmt/format.h>

#include "runtime/script/engine/engine.h"

namespace gsim::script {

using text::DiagnosticKind;

Script Script::from_text(std::string text, std::string file_name, std::int64_t line_offset) {
    Script script;
    script.file_name = std::move(file_name);
    script.line_offset = line_offset;
    script.size = text.size();
    script.retained_bytes = text.size();
    // Scripts are copied; their text is not.
    script.read = [buffer = std::make_shared<const std::string>(std::move(text))](
                      std::uint64_t begin, std::uint64_t end) { return buffer->substr(begin, end - begin); };
    return script;
}

// --- Scripts ---

/// Gives a file the same number for all robots.
Engine::LoadedScript& Engine::add_script(lua_State* state, Script script, RobotController& controller) {
    lua_.add_external_bytes(state, script.retained_bytes, kScriptText);
    loaded_scripts_.push_back(std::make_unique<LoadedScript>());
    LoadedScript& loaded_script = *loaded_scripts_.back();
    loaded_script.script = std::move(script);
    loaded_script.controller = &controller;
    for (const std::unique_ptr<RobotController>& each : controllers_)
        loaded_script.file = each->simulator().program().files().add(loaded_script.script.file_name);
    return loaded_script;
}

/// Pushes a function that loads the script: registers its functions and runs its other statements.
void Engine::push_script(lua_State* state, LoadedScript& loaded_script) {
    if (loaded_script.script.functions.empty())
        return compile(state, loaded_script, {0, loaded_script.script.size, 1});
    lua_pushlightuserdata(state, this);
    lua_pushlightuserdata(state, &loaded_script);
    lua_pushcclosure(state, trampoline<register_functions>, 2);
}

/// Calls what the script would call with each of its functions, such as `program(12, ...)`, with one that
/// compiles its parts.
int Engine::register_functions(lua_State* state) {
    auto& engine = bound<Engine>(state);
    auto& loaded_script = *static_cast<LoadedScript*>(lua_touserdata(state, lua_upvalueindex(2)));
    for (std::size_t i = 0; i < loaded_script.script.functions.size(); ++i) {
        const ScriptFunction& function = loaded_script.script.functions[i];
        const std::int64_t line = loaded_script.script.line_offset + function.chunks.front().line;
        loaded_script.controller->push_environment(state);
        const std::uint32_t text = engine.source_locator_.add({loaded_script.file, line - 1});
        load_text(state, function.head + "...)", SourceLocator::chunk_name(text).c_str());
        lua_pushlightuserdata(state, &engine);
        lua_pushlightuserdata(state, &loaded_script);
        lua_pushinteger(state, static_cast<lua_Integer>(i));
        lua_pushcclosure(state, trampoline<function_body>, 3);
        lua_call(state, 1, 0);
    }
    return 0;
}

/// Returns the number of the text that begins here, for source locations.
std::uint32_t Engine::text_number(LoadedScript& loaded_script, std::uint64_t begin, std::uint32_t line) {
    const auto [found, is_new] = loaded_script.texts.try_emplace(begin, 0);
    if (is_new)
        found->second =
            source_locator_.add({loaded_script.file, loaded_script.script.line_offset + line - 1});
    return found->second;
}

/// Compiles one section of a script; the function is left on the stack.
void Engine::compile(lua_State* state, LoadedScript& loaded_script, const ScriptChunk& chunk) {
    const std::uint32_t text = text_number(loaded_script, chunk.begin, chunk.line);
    loaded_script.controller->push_environment(state);
    const ExternalMemoryGuard copy(state, chunk.end - chunk.begin, kScriptText);
    const auto lua = loaded_script.script.read(chunk.begin, chunk.end);
    if (!lua) loaded_script.controller->interpreter().alarm(state, DiagnosticKind::file, lua.error().message);
    load_text(state, *lua, SourceLocator::chunk_name(text).c_str());
}

/// core.load_program(number or name): a function that loads the file of that program, or nil. A file is read
/// once.
int Engine::load_program(lua_State* state) {
    Engine& engine = bound<Engine>(state);
    auto& controller = *static_cast<RobotController*>(lua_touserdata(state, lua_upvalueindex(2)));
    const std::string name =
        lua_isinteger(state, 1) != 0 ? std::to_string(lua_tointeger(state, 1)) : luaL_checkstring(state, 1);
    LoadedScript*& kept = engine.programs_[{&controller, name}];
    if (kept == nullptr) {
        if (!controller.find_program()) return 0;
        Result<std::optional<Script>> script = controller.find_program()(name);
        if (!script)
            controller.interpreter().alarm(state, DiagnosticKind::program_missing, script.error().message);
        if (!*script) return 0;
        kept = &engine.add_script(state, std::move(**script), controller);
    }
    engine.push_script(state, *kept);
    return 1;
}

/// core.load_module(name): a function that runs the file of that module; or nil and the reason.
int Engine::load_module(lua_State* state) {
    Engine& engine = bound<Engine>(state);
    auto& controller = *static_cast<RobotController*>(lua_touserdata(state, lua_upvalueindex(2)));
    const std::string name = luaL_checkstring(state, 1);
    Result<std::optional<Script>> script;
    if (controller.find_module()) script = controller.find_module()(name);
    if (script && *script) {
        engine.push_script(state, engine.add_script(state, std::move(**script), controller));
        return 1;
    }
    const std::string reason = script ? "this run has no module folder" : script.error().message;
    lua_pushnil(state);
    lua_pushlstring(state, reason.data(), reason.size());
    return 2;
}

/// core.run_to_end(f): f(), up to the end of a program within.
int Engine::run_to_end(lua_State* state) {
    auto& controller = *static_cast<RobotController*>(lua_touserdata(state, lua_upvalueindex(2)));
    controller.interpreter().consume_program_end();
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
    auto& controller = *static_cast<RobotController*>(lua_touserdata(state, lua_upvalueindex(2)));
    const bool program_end = controller.interpreter().consume_program_end();
    if (status == LUA_ERRRUN && LuaState::is_stop(state, -1) && program_end &&
        lua.ended() == LuaState::StopReason::no)
        return 0;
    Engine& engine = bound<Engine>(state);
    engine.process_result(status, state, controller);
    LuaState::raise_stop(state);
}

}  // namespace gsim::script
