#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "runtime/script/bindings/bindings.h"
#include "runtime/script/lua/check_option.h"
#include "runtime/script/lua/lua_state.h"
#include "runtime/script/words/word_advice.h"
#include "runtime/script/words/word_id.h"

namespace gsim::script {

using text::DiagnosticKind;

namespace {

// --- Words ---

int return_results(lua_State* state, int, lua_KContext) {
    return lua_gettop(state);
}

/// Calls a word in Lua; upvalues: interpreter, function, id. It may wait for other processes.
int call_word(lua_State* state) {
    bound_interpreter(state).enter(state,
                                   static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3))));
    lua_pushvalue(state, lua_upvalueindex(2));
    lua_insert(state, 1);
    lua_callk(state, lua_gettop(state) - 1, LUA_MULTRET, 0, return_results);
    return return_results(state, LUA_OK, 0);
}

/// core.word(id, function): makes the function a word of the language, which counts blocks and knows its
/// source location.
int make_counted_word(lua_State* state) {
    const lua_Integer id = check_word_id(state, 1);
    luaL_checktype(state, 2, LUA_TFUNCTION);
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_pushvalue(state, 2);
    lua_pushinteger(state, id);
    lua_pushcclosure(state, trampoline<call_word>, 3);
    return 1;
}

DiagnosticKind check_kind(lua_State* state, int index) {
    const char* code = luaL_checkstring(state, index);
    const std::optional<DiagnosticKind> kind = text::diagnostic_kind(code);
    if (!kind) luaL_error(state, "'%s' is not a diagnostic code", code);
    return *kind;
}

/// core.alarm(kind, message): ends the run; the kind by its code.
int alarm(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    interpreter.locate(state);  // an expression has no word that would have set its location
    interpreter.alarm(state, check_kind(state, 1), luaL_checkstring(state, 2));
}

/// core.note_place(): remembers the script's source location.
int locate_word(lua_State* state) {
    bound_interpreter(state).locate(state);
    return 0;
}

int alarm_at_location(lua_State* state) {
    bound_interpreter(state).alarm(state, check_kind(state, 1), luaL_checkstring(state, 2));
}

/// core.enter_program(name): enters a program that is called from here.
int enter_program(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    interpreter.simulator().program().calls().enter(luaL_checkstring(state, 1), interpreter.location());
    return 0;
}

/// core.repeat_program(): the program called last runs once more.
int repeat_program(lua_State* state) {
    bound_interpreter(state).simulator().program().calls().repeat();
    return 0;
}

/// core.note_pass(count, block or nil): ends a pass of the main program, which leads back to its start or
/// to that block.
int report_pass(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    simulation::Passes passes;
    passes.count = static_cast<std::uint64_t>(luaL_checkinteger(state, 1));
    passes.location = interpreter.location();
    if (!lua_isnoneornil(state, 2)) passes.to_block = luaL_checkinteger(state, 2);
    interpreter.simulator().program().calls().set_passes(passes);
    return 0;
}

int leave_program(lua_State* state) {
    bound_interpreter(state).simulator().program().calls().leave();
    return 0;
}

/// core.stop(message): ends the run as a limit does.
int stop(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    interpreter.simulator().outcome().stop(DiagnosticKind::run_limit, luaL_checkstring(state, 1),
                                           interpreter.location());
    LuaState::raise_stop(state);
}

/// core.time(): seconds of the machine since the start.
int time(lua_State* state) {
    lua_pushnumber(state, bound_interpreter(state).simulator().clock().time_s());
    return 1;
}

int warn(lua_State* state) {
    bound_interpreter(state).simulator().warnings().add(luaL_checkstring(state, 1));
    return 0;
}

/// core.finish(): the program is at its end.
int finish(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    interpreter.simulator().program().process().end_program(interpreter.location());
    interpreter.end_program();
    LuaState::raise_stop(state);
}

/// core.word_advice(key, value, keys), see word_advice().
int push_word_advice(lua_State* state) {
    const std::string_view key = luaL_checkstring(state, 1);
    std::optional<double> value;
    if (lua_type(state, 2) == LUA_TNUMBER) value = lua_tonumber(state, 2);
    luaL_checktype(state, 3, LUA_TTABLE);
    std::vector<std::string_view> used_letters;
    const lua_Integer count = luaL_len(state, 3);
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(state, 3, i);
        used_letters.emplace_back(luaL_checkstring(state, -1));  // the table keeps it
        lua_pop(state, 1);
    }
    const std::string advice = word_advice(key, value, used_letters);
    lua_pushlstring(state, advice.data(), advice.size());
    return 1;
}

// --- Modal state ---

int unit_mm(lua_State* state) {
    lua_pushnumber(state, bound_interpreter(state).unit_mm());
    return 1;
}

int is_incremental(lua_State* state) {
    lua_pushboolean(state, static_cast<int>(bound_interpreter(state).modal().incremental));
    return 1;
}

int spindle_rpm(lua_State* state) {
    lua_pushnumber(state, bound_interpreter(state).modal().spindle_rpm);
    return 1;
}

int set_unit(lua_State* state) {
    bound_interpreter(state).set_unit_mm(luaL_checknumber(state, 1));
    return 0;
}

int set_incremental(lua_State* state) {
    bound_interpreter(state).modal().incremental = lua_toboolean(state, 1) != 0;
    return 0;
}

int set_feed(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    const double value = luaL_checknumber(state, 1);
    if (!(value > 0) || !std::isfinite(value))
        interpreter.alarm(state, DiagnosticKind::word_value,
                          fmt::format("F must be a number above 0, not {:.10g}", value));
    interpreter.modal().feed = value;
    interpreter.modal().feed_unit_mm = interpreter.unit_mm();
    interpreter.modal().feed_is_new = true;
    return 0;
}

/// core.clear_feed(): no feed is active.
int reset_feed(lua_State* state) {
    bound_interpreter(state).modal().feed = 0;
    return 0;
}

/// core.set_letters_uvw(increments): true if U, V and W are increments of X, Y and Z when no axis has the
/// letter.
int set_letters_uvw(lua_State* state) {
    bound_interpreter(state).modal().uvw_increments = lua_toboolean(state, 1) != 0;
    return 0;
}

/// core.set_inverse_time_of_arcs(by_angle): F of an arc is the inverse of its time per radian, or of its
/// time.
int set_inverse_time_of_arcs(lua_State* state) {
    bound_interpreter(state).modal().inverse_time_by_angle = lua_toboolean(state, 1) != 0;
    return 0;
}

constexpr std::array<const char*, 4> kFeedModes{"minute", "inverse", "revolution", nullptr};

int feed_mode(lua_State* state) {
    lua_pushstring(state, kFeedModes[static_cast<std::size_t>(bound_interpreter(state).modal().feed_mode)]);
    return 1;
}

int set_feed_mode(lua_State* state) {
    ModalState& modal = bound_interpreter(state).modal();
    const auto mode = static_cast<FeedMode>(check_option(state, 1, nullptr, kFeedModes));
    if (mode != modal.feed_mode) modal.feed = 0;  // an F of one mode has no meaning in another
    modal.feed_mode = mode;
    return 0;
}

int set_spindle(lua_State* state) {
    bound_interpreter(state).modal().spindle_rpm = luaL_checknumber(state, 1);
    return 0;
}

// --- Machine ---

int axes(lua_State* state) {
    const auto& list = bound_interpreter(state).simulator().machine().axes;
    lua_createtable(state, static_cast<int>(list.size()), 0);
    for (std::size_t i = 0; i < list.size(); ++i) {
        lua_createtable(state, 0, 4);
        const char letter = static_cast<char>(list[i].letter | 0x20);
        lua_pushlstring(state, &letter, 1);
        lua_setfield(state, -2, "letter");
        lua_pushboolean(state, static_cast<int>(list[i].kind == machine::AxisKind::rotary));
        lua_setfield(state, -2, "rotary");
        lua_pushnumber(state, list[i].home);
        lua_setfield(state, -2, "home");
        lua_pushboolean(state, static_cast<int>(list[i].turning == machine::RotaryMode::unwind));
        lua_setfield(state, -2, "unwinds");
        lua_rawseti(state, -2, static_cast<lua_Integer>(i) + 1);
    }
    return 1;
}

/// core.set_process(on, with_motion)
int set_process(lua_State* state) {
    bound_interpreter(state).simulator().program().process().set(lua_toboolean(state, 1) != 0,
                                                                 lua_toboolean(state, 2) != 0);
    return 0;
}

}  // namespace

void add_core(lua_State* state, Interpreter& interpreter) {
    set_function<make_counted_word>(state, "word", &interpreter);
    set_function<alarm>(state, "alarm", &interpreter);
    set_function<locate_word>(state, "note_place", &interpreter);
    set_function<alarm_at_location>(state, "alarm_at_noted_place", &interpreter);
    set_function<enter_program>(state, "enter_program", &interpreter);
    set_function<repeat_program>(state, "repeat_program", &interpreter);
    set_function<push_word_advice>(state, "word_advice", &interpreter);
    set_function<report_pass>(state, "note_pass", &interpreter);
    set_function<leave_program>(state, "leave_program", &interpreter);
    set_function<stop>(state, "stop", &interpreter);
    set_function<time>(state, "time", &interpreter);
    set_function<warn>(state, "warn", &interpreter);
    set_function<finish>(state, "finish", &interpreter);
    set_function<unit_mm>(state, "unit_mm", &interpreter);
    set_function<is_incremental>(state, "is_incremental", &interpreter);
    set_function<feed_mode>(state, "feed_mode", &interpreter);
    set_function<spindle_rpm>(state, "spindle_rpm", &interpreter);
    set_function<set_unit>(state, "set_unit", &interpreter);
    set_function<set_incremental>(state, "set_incremental", &interpreter);
    set_function<set_feed>(state, "set_feed", &interpreter);
    set_function<reset_feed>(state, "clear_feed", &interpreter);
    set_function<set_letters_uvw>(state, "set_letters_uvw", &interpreter);
    set_function<set_inverse_time_of_arcs>(state, "set_inverse_time_of_arcs", &interpreter);
    set_function<set_feed_mode>(state, "set_feed_mode", &interpreter);
    set_function<set_spindle>(state, "set_spindle", &interpreter);
    set_function<axes>(state, "axes", &interpreter);
    set_function<set_process>(state, "set_process", &interpreter);
}

}  // namespace gsim::script
