// Execution of script functions that come in parts. Compiling a line once takes longer than everything else
// that is done for it. So lines of plain calls become calls right away, and Lua compiles the others.

#include <algorithm>
#include <new>
#include <span>
#include <type_traits>

#include "runtime/script/engine/engine.h"
#include "runtime/script/lua/plain_calls.h"

namespace gsim::script {

namespace {

// Index on the stack of a body, after its walk.
constexpr int kEnvironment = 2;
constexpr int kFirstKey = 3;  // "a"
constexpr int kLetters = 26;
constexpr int kStackForCall = 8;

/// Instructions of Lua for a call without values, and for each value.
constexpr std::uint64_t kStepsOfCall = 3;

void push_key(lua_State* state, std::string_view key) {
    if (key.size() == 1 && key[0] >= 'a' && key[0] <= 'z') {
        lua_pushvalue(state, kFirstKey + (key[0] - 'a'));
    } else {
        lua_pushlstring(state, key.data(), key.size());
    }
}

void push_number(lua_State* state, const PlainCall::Number& number) {
    if (const auto* integer = std::get_if<lua_Integer>(&number)) {
        lua_pushinteger(state, *integer);
    } else {
        lua_pushnumber(state, std::get<lua_Number>(number));
    }
}

/// Pushes what the script sees under this name; returns true if that is a function.
bool push_word(lua_State* state, std::string_view word) {
    lua_pushlstring(state, word.data(), word.size());
    lua_rawget(state, kEnvironment);
    return lua_isfunction(state, -1);
}

/// Pushes the values of a call; returns their number.
int push_values(lua_State* state, const PlainCall& call) {
    if (call.argument) push_number(state, *call.argument);
    if (!call.has_table) return call.argument ? 1 : 0;
    lua_createtable(state, 0, static_cast<int>(call.field_count));
    for (const PlainCall::Field& field : call.fields()) {
        push_key(state, field.key);
        push_number(state, field.value);
        lua_rawset(state, -3);
    }
    return 1;
}

bool has_line_hook(lua_State* state) {
    return (lua_gethookmask(state) & LUA_MASKLINE) != 0;
}

/// Continues after a function that has waited for other processes; its result is the caller's.
int return_result(lua_State*, int, lua_KContext) {
    return 1;
}

}  // namespace

/// Progress of the run of a body; the first value on its stack.
struct Engine::BodyExecution {
    LinePosition position;      ///< Position of the current line in the script.
    std::size_t chunk;          ///< The one that runs.
    std::uint64_t offset;       ///< Current line, as an offset of the text.
    std::size_t calls_started;  ///< Calls of that line.
    bool has_waited;            ///< It has yielded to other processes in this chunk.
    bool compiled;              ///< The remainder of the chunk runs as Lua compiled it.

    void begin(const ScriptChunk& started_chunk) {
        offset = started_chunk.begin;
        position.line = started_chunk.line;
        compiled = has_waited = false;
    }
};

/// Runs the body of a function that comes in parts; upvalues: engine, script, number of the function in it.
int Engine::function_body(lua_State* state) {
    Engine& engine = bound<Engine>(state);
    auto& loaded_script = *static_cast<LoadedScript*>(lua_touserdata(state, lua_upvalueindex(2)));
    const auto index = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3)));
    const std::vector<ScriptChunk>& chunks = loaded_script.script.functions[index].chunks;
    if (chunks.size() == 1) {
        const auto [entry, is_new] = loaded_script.compiled.try_emplace(index, LUA_NOREF);
        if (!is_new) return engine.run_compiled(state, loaded_script, chunks.front(), entry->second);
    }
    lua_settop(state, 0);
    luaL_checkstack(state, kFirstKey + kLetters + kStackForCall, nullptr);
    static_assert(std::is_trivially_destructible_v<BodyExecution>);
    auto& execution = *new (lua_newuserdatauv(state, sizeof(BodyExecution), 0)) BodyExecution();
    execution.position = SourceLocator::begin(engine.text_number(loaded_script, 0, 1));
    execution.begin(chunks.front());
    loaded_script.controller->push_environment(state);
    for (char letter = 'a'; letter <= 'z'; ++letter) lua_pushlstring(state, &letter, 1);
    return engine.run_body(state, execution);
}

/// Runs a subprogram that is called again, which is worth compiling.
int Engine::run_compiled(lua_State* state, LoadedScript& loaded_script, const ScriptChunk& chunk,
                         int& compiled) {
    if (compiled == LUA_NOREF) {
        compile(state, loaded_script, chunk);
        compiled = luaL_ref(state, LUA_REGISTRYINDEX);
    }
    lua_rawgeti(state, LUA_REGISTRYINDEX, compiled);
    lua_callk(state, 0, 1, 0, return_result);
    return 1;
}

/// Continues the body of function_body(), with its upvalues in the state.
int Engine::run_body(lua_State* state, BodyExecution& execution) {
    auto& loaded_script = *static_cast<LoadedScript*>(lua_touserdata(state, lua_upvalueindex(2)));
    const auto index = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3)));
    const std::vector<ScriptChunk>& chunks = loaded_script.script.functions[index].chunks;
    for (;;) {
        const ScriptChunk& chunk = chunks[execution.chunk];
        if (!execution.compiled) {
            run_plain_lines(state, loaded_script, execution, chunk);
            if (execution.offset < chunk.end) {
                execution.compiled = true;
                const auto line = static_cast<std::uint32_t>(execution.position.line);
                compile(state, loaded_script, {execution.offset, chunk.end, line});
                lua_callk(state, 0, 1, 0, continue_body);
                if (!lua_isnil(state, -1)) return 1;
                lua_pop(state, 1);
            }
        }
        if (options_.progress && chunks.size() > 1) options_.progress(chunk.end, loaded_script.script.size);
        if (++execution.chunk == chunks.size()) return 0;
        execution.begin(chunks[execution.chunk]);
    }
}

/// Runs lines from that of the walk on, up to the end of the chunk or to one that is no plain call; the walk
/// is then there.
void Engine::run_plain_lines(lua_State* state, LoadedScript& loaded_script, BodyExecution& execution,
                             const ScriptChunk& chunk) {
    const ExternalMemoryGuard copy(state, chunk.end - execution.offset, kScriptText);
    const auto read = loaded_script.script.read(execution.offset, chunk.end);
    if (!read)
        loaded_script.controller->interpreter().alarm(state, text::DiagnosticKind::file,
                                                      read.error().message);
    const std::string& text = *read;
    PlainLine line;
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (!line.read(std::string_view(text).substr(begin, end - begin))) return;
        const std::span<const PlainCall> calls = line.calls();
        if (execution.calls_started == 0 && (execution.has_waited || has_line_hook(state))) return;
        while (execution.calls_started < calls.size()) {
            const PlainCall& call = calls[execution.calls_started];
            if (!push_word(state, call.word)) {
                lua_pop(state, 1);
                execution.offset += static_cast<std::uint64_t>(call.word.data() - &text[begin]);
                execution.calls_started = 0;
                return;
            }
            ++execution.calls_started;
            lua_.count_instructions(state, kStepsOfCall + call.field_count);
            lua_callk(state, push_values(state, call), 0, 0, continue_body);
        }
        execution.calls_started = 0;
        execution.offset += end + 1 - begin;
        ++execution.position.line;
        begin = end + 1;
    }
}

/// Continues after a call that has waited for other processes.
int Engine::continue_body(lua_State* state, int, lua_KContext) {
    auto& execution = *static_cast<BodyExecution*>(lua_touserdata(state, 1));
    try {
        execution.has_waited = true;
        if (execution.compiled) {
            if (!lua_isnil(state, -1)) return 1;
            lua_pop(state, 1);
        }
        return bound<Engine>(state).run_body(state, execution);
    } catch (const std::exception& error) {
        lua_pushstring(state, error.what());
    }
    return lua_error(state);
}

}  // namespace gsim::script
