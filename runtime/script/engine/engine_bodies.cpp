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

bool lines_are_watched(lua_State* state) {
    return (lua_gethookmask(state) & LUA_MASKLINE) != 0;
}

/// Continues after a function that has waited for other processes; its result is the caller's.
int return_result(lua_State*, int, lua_KContext) {
    return 1;
}

}  // namespace

/// Progress of the run of a body; the first value on its stack.
struct Engine::BodyWalk {
    LinePosition position;    ///< Position of the current line in the script.
    std::size_t chunk;        ///< The one that runs.
    std::uint64_t offset;     ///< Current line, as an offset of the text.
    std::size_t calls_begun;  ///< Calls of that line.
    bool waited;              ///< It has yielded to other processes in this chunk.
    bool compiled;            ///< The remainder of the chunk runs as Lua compiled it.

    void begin(const ScriptChunk& chunk_begun) {
        offset = chunk_begun.begin;
        position.line = chunk_begun.line;
        compiled = waited = false;
    }
};

/// Runs the body of a function that comes in parts; upvalues: engine, script, number of the function in it.
int Engine::function_body(lua_State* state) {
    Engine& engine = bound<Engine>(state);
    auto& loaded = *static_cast<Loaded*>(lua_touserdata(state, lua_upvalueindex(2)));
    const auto index = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3)));
    const std::vector<ScriptChunk>& chunks = loaded.script.functions[index].chunks;
    if (chunks.size() == 1) {
        const auto [again, is_new] = loaded.compiled.try_emplace(index, LUA_NOREF);
        if (!is_new) return engine.run_again(state, loaded, chunks.front(), again->second);
    }
    lua_settop(state, 0);
    luaL_checkstack(state, kFirstKey + kLetters + kStackForCall, nullptr);
    static_assert(std::is_trivially_destructible_v<BodyWalk>);
    auto& walk = *new (lua_newuserdatauv(state, sizeof(BodyWalk), 0)) BodyWalk();
    walk.position = PlaceFinder::begin(engine.text_at(loaded, 0, 1));
    walk.begin(chunks.front());
    loaded.control->push_environment(state);
    for (char letter = 'a'; letter <= 'z'; ++letter) lua_pushlstring(state, &letter, 1);
    return engine.run_body(state, walk);
}

/// Runs a subprogram that is called again, which is worth compiling.
int Engine::run_again(lua_State* state, Loaded& loaded, const ScriptChunk& chunk, int& compiled) {
    if (compiled == LUA_NOREF) {
        compile(state, loaded, chunk);
        compiled = luaL_ref(state, LUA_REGISTRYINDEX);
    }
    lua_rawgeti(state, LUA_REGISTRYINDEX, compiled);
    lua_callk(state, 0, 1, 0, return_result);
    return 1;
}

/// Continues the body of function_body(), with its upvalues in the state.
int Engine::run_body(lua_State* state, BodyWalk& walk) {
    auto& loaded = *static_cast<Loaded*>(lua_touserdata(state, lua_upvalueindex(2)));
    const auto index = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3)));
    const std::vector<ScriptChunk>& chunks = loaded.script.functions[index].chunks;
    for (;;) {
        const ScriptChunk& chunk = chunks[walk.chunk];
        if (!walk.compiled) {
            run_plain_lines(state, loaded, walk, chunk);
            if (walk.offset < chunk.end) {
                walk.compiled = true;
                const auto line = static_cast<std::uint32_t>(walk.position.line);
                compile(state, loaded, {walk.offset, chunk.end, line});
                lua_callk(state, 0, 1, 0, go_on_with_body);
                if (!lua_isnil(state, -1)) return 1;
                lua_pop(state, 1);
            }
        }
        if (options_.progress && chunks.size() > 1) options_.progress(chunk.end, loaded.script.size);
        if (++walk.chunk == chunks.size()) return 0;
        walk.begin(chunks[walk.chunk]);
    }
}

/// Runs lines from that of the walk on, up to the end of the chunk or to one that is no plain call; the walk
/// is then there.
void Engine::run_plain_lines(lua_State* state, Loaded& loaded, BodyWalk& walk, const ScriptChunk& chunk) {
    const HeldMemory copy(state, chunk.end - walk.offset, kTextOfScript);
    const auto read = loaded.script.read(walk.offset, chunk.end);
    if (!read) loaded.control->interpreter().alarm(state, text::DiagnosticKind::file, read.error());
    const std::string& text = *read;
    PlainLine line;
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (!line.read(std::string_view(text).substr(begin, end - begin))) return;
        const std::span<const PlainCall> calls = line.calls();
        if (walk.calls_begun == 0 && (walk.waited || lines_are_watched(state))) return;
        while (walk.calls_begun < calls.size()) {
            const PlainCall& call = calls[walk.calls_begun];
            if (!push_word(state, call.word)) {
                lua_pop(state, 1);
                walk.offset += static_cast<std::uint64_t>(call.word.data() - &text[begin]);
                walk.calls_begun = 0;
                return;
            }
            ++walk.calls_begun;
            lua_.count_instructions(state, kStepsOfCall + call.field_count);
            lua_callk(state, push_values(state, call), 0, 0, go_on_with_body);
        }
        walk.calls_begun = 0;
        walk.offset += end + 1 - begin;
        ++walk.position.line;
        begin = end + 1;
    }
}

/// Continues after a call that has waited for other processes.
int Engine::go_on_with_body(lua_State* state, int, lua_KContext) {
    auto& walk = *static_cast<BodyWalk*>(lua_touserdata(state, 1));
    try {
        walk.waited = true;
        if (walk.compiled) {
            if (!lua_isnil(state, -1)) return 1;
            lua_pop(state, 1);
        }
        return bound<Engine>(state).run_body(state, walk);
    } catch (const std::exception& error) {
        lua_pushstring(state, error.what());
    }
    return lua_error(state);
}

}  // namespace gsim::script
