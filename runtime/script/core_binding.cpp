#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "runtime/script/axis_table.h"
#include "runtime/script/bindings.h"
#include "runtime/script/lua_state.h"

namespace gsim::script {

using simulation::AxisVector;

namespace {

Controller& self(lua_State* state) {
    return bound<Controller>(state);
}

int check_axis(lua_State* state, int argument) {
    const std::string_view letter = luaL_checkstring(state, argument);
    const int axis = letter.size() == 1 ? self(state).axis(letter[0]) : -1;
    luaL_argcheck(state, axis >= 0, argument, "no axis of the machine");
    return axis;
}

// --- Words ---

/// A word in Lua; upvalues: controller, function, id.
int call_word(lua_State* state) {
    self(state).enter(state, static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3))));
    lua_pushvalue(state, lua_upvalueindex(2));
    lua_insert(state, 1);
    lua_call(state, lua_gettop(state) - 1, LUA_MULTRET);
    return lua_gettop(state);
}

/// core.word(id, function): the function as a word of the language, which counts blocks and knows its place.
int make_word(lua_State* state) {
    const lua_Integer id = luaL_checkinteger(state, 1);
    luaL_argcheck(state, id >= 0 && id < static_cast<lua_Integer>(kMaxWordIds), 1, "no word id");
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

int finish(lua_State* state) {
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

int set_offset(lua_State* state) {
    self(state).modal().offset[check_axis(state, 1)] = luaL_checknumber(state, 2);
    return 0;
}

int machine_frame_once(lua_State* state) {
    self(state).modal().machine_frame_once = true;
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
        lua_createtable(state, 0, 3);
        const char letter = static_cast<char>(list[i].letter | 0x20);
        lua_pushlstring(state, &letter, 1);
        lua_setfield(state, -2, "letter");
        lua_pushboolean(state, static_cast<int>(list[i].kind == machine::AxisKind::rotary));
        lua_setfield(state, -2, "rotary");
        lua_pushnumber(state, list[i].home);
        lua_setfield(state, -2, "home");
        lua_rawseti(state, -2, static_cast<lua_Integer>(i) + 1);
    }
    return 1;
}

int position(lua_State* state) {
    lua_pushnumber(state, self(state).simulator().position()[check_axis(state, 1)]);
    return 1;
}

/// core.target(words, others): machine coordinates of all axes after the move, and whether any axis is named.
int target(lua_State* state) {
    AxisVector values;
    const bool any = self(state).read_target(state, 1, luaL_optstring(state, 2, ""), values);
    push_axes(state, self(state), values);
    lua_pushboolean(state, static_cast<int>(any));
    return 2;
}

/// core.rapid_to(target): a rapid to machine coordinates.
int rapid_to(lua_State* state) {
    Controller& controller = self(state);
    simulation::LineMove move;
    move.rapid = true;
    move.target = check_axes(state, controller, 1);
    move.place = controller.place();
    controller.check(state, controller.simulator().move(move));
    return 0;
}

/// core.arc(plane, counterclockwise, center_first, center_second, sweep_rad, target)
int arc(lua_State* state) {
    static const char* const kPlanes[] = {"xy", "zx", "yz", nullptr};
    Controller& controller = self(state);
    simulation::ArcMove move;
    move.plane = static_cast<simulation::Plane>(luaL_checkoption(state, 1, nullptr, kPlanes));
    move.kind = lua_toboolean(state, 2) != 0 ? simulation::MoveKind::arc_ccw : simulation::MoveKind::arc_cw;
    move.center_first_mm = luaL_checknumber(state, 3);
    move.center_second_mm = luaL_checknumber(state, 4);
    move.sweep_rad = luaL_checknumber(state, 5);
    move.target = check_axes(state, controller, 6);
    move.feed = controller.feed(state, move.sweep_rad);
    move.place = controller.place();
    controller.check(state, controller.simulator().move(move));
    return 0;
}

/// core.arc_via(via, target, sweep_rad): an arc through a point.
int arc_via(lua_State* state) {
    Controller& controller = self(state);
    simulation::ViaMove move;
    move.via = check_axes(state, controller, 1);
    move.target = check_axes(state, controller, 2);
    move.feed = controller.feed(state, luaL_checknumber(state, 3));
    move.place = controller.place();
    controller.check(state, controller.simulator().move(move));
    return 0;
}

int dwell(lua_State* state) {
    Controller& controller = self(state);
    const double seconds = luaL_checknumber(state, 1);
    if (!(seconds >= 0) || !std::isfinite(seconds))
        controller.alarm(state, fmt::format("a dwell takes 0 seconds or more, not {:.10g}", seconds));
    controller.check(state, controller.simulator().dwell(seconds, controller.place()));
    return 0;
}

int event(lua_State* state) {
    Controller& controller = self(state);
    controller.simulator().event(luaL_checkstring(state, 1), luaL_optstring(state, 2, ""),
                                 controller.place());
    return 0;
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
    set_function<stop>(state, "stop", &controller);
    set_function<time>(state, "time", &controller);
    set_function<warn>(state, "warn", &controller);
    set_function<finish>(state, "finish", &controller);
    set_function<set_unit>(state, "set_unit", &controller);
    set_function<set_incremental>(state, "set_incremental", &controller);
    set_function<set_offset>(state, "set_offset", &controller);
    set_function<machine_frame_once>(state, "machine_frame_once", &controller);
    set_function<set_feed>(state, "set_feed", &controller);
    set_function<set_feed_mode>(state, "set_feed_mode", &controller);
    set_function<set_spindle>(state, "set_spindle", &controller);
    set_function<axes>(state, "axes", &controller);
    set_function<position>(state, "position", &controller);
    set_function<target>(state, "target", &controller);
    set_function<rapid_to>(state, "rapid_to", &controller);
    set_function<arc>(state, "arc", &controller);
    set_function<arc_via>(state, "arc_via", &controller);
    set_function<dwell>(state, "dwell", &controller);
    set_function<event>(state, "event", &controller);
    set_function<jet>(state, "jet", &controller);
}

}  // namespace gsim::script
