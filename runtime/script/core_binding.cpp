#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "runtime/script/bindings.h"
#include "runtime/script/lua_state.h"
#include "runtime/script/word_id.h"

namespace gsim::script {

namespace {

Controller& self(lua_State* state) {
    return bound<Controller>(state);
}

// --- Words ---

int return_all(lua_State* state, int, lua_KContext) {
    return lua_gettop(state);
}

/// A word in Lua; upvalues: controller, function, id. It may wait for other processes.
int call_word(lua_State* state) {
    self(state).enter(state, static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3))));
    lua_pushvalue(state, lua_upvalueindex(2));
    lua_insert(state, 1);
    lua_callk(state, lua_gettop(state) - 1, LUA_MULTRET, 0, return_all);
    return return_all(state, LUA_OK, 0);
}

/// core.word(id, function): the function as a word of the language, which counts blocks and knows its place.
int make_word(lua_State* state) {
    const lua_Integer id = check_word_id(state, 1);
    luaL_checktype(state, 2, LUA_TFUNCTION);
    lua_pushvalue(state, lua_upvalueindex(1));
    lua_pushvalue(state, 2);
    lua_pushinteger(state, id);
    lua_pushcclosure(state, trampoline<call_word>, 3);
    return 1;
}

int alarm(lua_State* state) {
    Controller& controller = self(state);
    controller.locate(state);  // an expression has no word that would have told its place
    controller.alarm(state, luaL_checkstring(state, 1));
}

/// core.note_place(): remembers where the script is.
int note_place(lua_State* state) {
    self(state).locate(state);
    return 0;
}

int alarm_at_noted_place(lua_State* state) {
    self(state).alarm(state, luaL_checkstring(state, 1));
}

/// core.enter_program(name): a program is called from here.
int enter_program(lua_State* state) {
    Controller& controller = self(state);
    controller.simulator().enter_program(luaL_checkstring(state, 1), controller.place());
    return 0;
}

/// core.repeat_program(): the program called last is gone through once more.
int repeat_program(lua_State* state) {
    self(state).simulator().repeat_program();
    return 0;
}

int leave_program(lua_State* state) {
    self(state).simulator().leave_program();
    return 0;
}

/// core.stop(message): ends the run as a limit does.
int stop(lua_State* state) {
    Controller& controller = self(state);
    controller.simulator().stop(luaL_checkstring(state, 1), controller.place());
    LuaState::raise_stop(state);
}

/// core.time(): seconds of the machine since the start.
int time(lua_State* state) {
    lua_pushnumber(state, self(state).simulator().time_s());
    return 1;
}

int warn(lua_State* state) {
    self(state).simulator().warn(luaL_checkstring(state, 1));
    return 0;
}

/// core.finish(): the program is at its end.
int finish(lua_State* state) {
    self(state).end_program();
    LuaState::raise_stop(state);
}

// --- Modal state ---

int set_unit(lua_State* state) {
    self(state).modal().unit_mm = luaL_checknumber(state, 1);
    return 0;
}

int set_incremental(lua_State* state) {
    self(state).modal().incremental = lua_toboolean(state, 1) != 0;
    return 0;
}

int set_feed(lua_State* state) {
    Controller& controller = self(state);
    const double value = luaL_checknumber(state, 1);
    if (!(value > 0) || !std::isfinite(value))
        controller.alarm(state, fmt::format("F is a number above 0, not {:.10g}", value));
    controller.modal().feed = value;
    controller.modal().feed_unit_mm = controller.modal().unit_mm;
    controller.modal().feed_is_new = true;
    return 0;
}

/// core.clear_feed(): no feed is in force.
int clear_feed(lua_State* state) {
    self(state).modal().feed = 0;
    return 0;
}

/// core.set_letters_uvw(increments): whether U, V and W are increments of X, Y and Z where no axis has the
/// letter.
int set_letters_uvw(lua_State* state) {
    self(state).modal().uvw_increments = lua_toboolean(state, 1) != 0;
    return 0;
}

/// core.set_inverse_time_of_arcs(by_angle): F of an arc is the inverse of its time per radian, or of its
/// time.
int set_inverse_time_of_arcs(lua_State* state) {
    self(state).modal().inverse_time_by_angle = lua_toboolean(state, 1) != 0;
    return 0;
}

int set_feed_mode(lua_State* state) {
    static const char* const kNames[] = {"minute", "inverse", "revolution", nullptr};
    ModalState& modal = self(state).modal();
    const auto mode = static_cast<FeedMode>(luaL_checkoption(state, 1, nullptr, kNames));
    if (mode != modal.feed_mode) modal.feed = 0;  // an F of one mode means nothing in another
    modal.feed_mode = mode;
    return 0;
}

int set_spindle(lua_State* state) {
    self(state).modal().spindle_rpm = luaL_checknumber(state, 1);
    return 0;
}

// --- Machine ---

int axes(lua_State* state) {
    const auto& list = self(state).simulator().machine().axes;
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
        lua_pushboolean(state, static_cast<int>(list[i].turning == machine::Turning::unwind));
        lua_setfield(state, -2, "unwinds");
        lua_rawseti(state, -2, static_cast<lua_Integer>(i) + 1);
    }
    return 1;
}

int jet(lua_State* state) {
    self(state).simulator().set_jet(lua_toboolean(state, 1) != 0);
    return 0;
}

}  // namespace

void add_core(lua_State* state, Controller& controller) {
    set_function<make_word>(state, "word", &controller);
    set_function<alarm>(state, "alarm", &controller);
    set_function<note_place>(state, "note_place", &controller);
    set_function<alarm_at_noted_place>(state, "alarm_at_noted_place", &controller);
    set_function<enter_program>(state, "enter_program", &controller);
    set_function<repeat_program>(state, "repeat_program", &controller);
    set_function<leave_program>(state, "leave_program", &controller);
    set_function<stop>(state, "stop", &controller);
    set_function<time>(state, "time", &controller);
    set_function<warn>(state, "warn", &controller);
    set_function<finish>(state, "finish", &controller);
    set_function<set_unit>(state, "set_unit", &controller);
    set_function<set_incremental>(state, "set_incremental", &controller);
    set_function<set_feed>(state, "set_feed", &controller);
    set_function<clear_feed>(state, "clear_feed", &controller);
    set_function<set_letters_uvw>(state, "set_letters_uvw", &controller);
    set_function<set_inverse_time_of_arcs>(state, "set_inverse_time_of_arcs", &controller);
    set_function<set_feed_mode>(state, "set_feed_mode", &controller);
    set_function<set_spindle>(state, "set_spindle", &controller);
    set_function<axes>(state, "axes", &controller);
    set_function<jet>(state, "jet", &controller);
}

}  // namespace gsim::script
