#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "runtime/script/bindings/arc_reader.h"
#include "runtime/script/bindings/bindings.h"
#include "runtime/script/lua/axis_table.h"
#include "runtime/script/lua/check_option.h"
#include "runtime/script/lua/lua_state.h"

namespace gsim::script {

using text::DiagnosticKind;

using simulation::AxisVector;
using simulation::Feed;
using simulation::MoveKind;
using simulation::SourceLocation;

namespace {

// --- Feeds and locations of a move that is output later ---

void push_feed(lua_State* state, const Feed& feed) {
    lua_createtable(state, 0, 4);
    lua_pushnumber(state, feed.linear_mm_min);
    lua_setfield(state, -2, "linear_mm_min");
    lua_pushnumber(state, feed.rotary_deg_min);
    lua_setfield(state, -2, "rotary_deg_min");
    if (feed.motion_s) {
        lua_pushnumber(state, *feed.motion_s);
        lua_setfield(state, -2, "motion_s");
    }
    if (feed.linear_mm_rev) {
        lua_pushnumber(state, *feed.linear_mm_rev);
        lua_setfield(state, -2, "linear_mm_rev");
    }
}

/// Returns the feed at `index`, or the active one if it is missing; `sweep_rad` for an arc.
Feed check_feed(lua_State* state, int index, std::optional<double> sweep_rad) {
    if (lua_isnoneornil(state, index)) return bound_interpreter(state).feed(state, sweep_rad);
    luaL_checktype(state, index, LUA_TTABLE);
    Feed feed;
    feed.linear_mm_min = number_field(state, index, "linear_mm_min");
    feed.rotary_deg_min = number_field(state, index, "rotary_deg_min");
    if (const double motion_s = number_field(state, index, "motion_s"); motion_s > 0)
        feed.motion_s = motion_s;
    if (const double rev = number_field(state, index, "linear_mm_rev"); rev > 0) feed.linear_mm_rev = rev;
    return feed;
}

SourceLocation check_location(lua_State* state, int index) {
    if (lua_isnoneornil(state, index)) return bound_interpreter(state).location();
    const auto code = static_cast<std::uint64_t>(luaL_checkinteger(state, index));
    return {static_cast<std::uint32_t>(code >> 32U), static_cast<std::uint32_t>(code)};
}

/// core.take_feed(sweep_rad or nil): the active feed; an F of inverse time feed is used up.
int consume_feed(lua_State* state) {
    std::optional<double> sweep_rad;
    if (!lua_isnoneornil(state, 1)) sweep_rad = luaL_checknumber(state, 1);
    push_feed(state, bound_interpreter(state).feed(state, sweep_rad));
    return 1;
}

/// core.feed_mm_min(value): a feed of that many mm/min, or deg/min if only rotary axes move.
int feed_mm_min(lua_State* state) {
    Feed feed;
    feed.linear_mm_min = luaL_checknumber(state, 1);
    feed.rotary_deg_min = feed.linear_mm_min;
    push_feed(state, feed);
    return 1;
}

int location(lua_State* state) {
    const SourceLocation current = bound_interpreter(state).location();
    lua_pushinteger(
        state, static_cast<lua_Integer>((static_cast<std::uint64_t>(current.file) << 32U) | current.line));
    return 1;
}

// --- Moves to machine coordinates ---

/// core.rapid_to(target, place)
int rapid_to(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    simulation::LineMove move;
    move.kind = MoveKind::rapid;
    move.target = check_axes(state, interpreter, 1);
    move.location = check_location(state, 2);
    interpreter.check(state, interpreter.simulator().moves().enqueue(move));
    return 0;
}

/// core.line_to(target, feed, place, kind)
int line_to(lua_State* state) {
    static const char* const kNames[] = {"linear", "thread", "spline", nullptr};
    static constexpr MoveKind kKinds[] = {MoveKind::linear, MoveKind::thread, MoveKind::spline};
    Interpreter& interpreter = bound_interpreter(state);
    simulation::LineMove move;
    move.target = check_axes(state, interpreter, 1);
    move.feed = check_feed(state, 2, std::nullopt);
    move.location = check_location(state, 3);
    move.kind = kKinds[check_option(state, 4, "linear", kNames)];
    interpreter.check(state, interpreter.simulator().moves().enqueue(move));
    return 0;
}

/// core.probe(target, feed, place, away, signal): a straight move that a signal ends; `away`: that contact is
/// lost. `signal` is nil, or the result of a script: false, or the share of the path at which it comes.
/// Returns whether it came, whether it was present before the move, and the machine coordinates at that
/// instant.
int probe(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    simulation::ProbeMove move;
    move.line.kind = MoveKind::probe;
    move.line.target = check_axes(state, interpreter, 1, interpreter.simulator().position().axes());
    move.line.feed = check_feed(state, 2, std::nullopt);
    move.line.location = check_location(state, 3);
    move.away = lua_toboolean(state, 4) != 0;
    if (lua_isnumber(state, 5) != 0) {
        move.response = simulation::ProbeMove::ProbeResponse::at_fraction;
        move.fraction = lua_tonumber(state, 5);
    } else if (!lua_isnoneornil(state, 5)) {
        move.response = simulation::ProbeMove::ProbeResponse::never;
    }
    simulation::ProbeResult result;
    interpreter.check(state, interpreter.simulator().probing().probe(move, result));
    lua_pushboolean(state, static_cast<int>(result.found));
    lua_pushboolean(state, static_cast<int>(result.at_start));
    push_axes(state, interpreter, result.at);
    return 3;
}

/// core.joint_to(target): all joints together, the slowest at its limits.
int joint_to(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    simulation::LineMove move;
    move.kind = MoveKind::rapid;
    move.target = check_axes(state, interpreter, 1);
    move.location = interpreter.location();
    interpreter.check(state, interpreter.simulator().moves().enqueue(move));
    return 0;
}

/// core.arc(plane, counterclockwise, center_first, center_second, sweep_rad, target, feed, place). The plane
/// is a name, or { first = {x=, y=, z=}, second = {...} }, two unit vectors at right angles along which the
/// centre is counted.
int arc(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    simulation::ArcMove move;
    const ArcBasis basis = check_arc_plane(state, 1);
    const Eigen::Vector3d axis = basis.first.cross(basis.second);
    move.normal = simulation::canonical_normal(axis);
    const bool counterclockwise = (lua_toboolean(state, 2) != 0) == (move.normal.dot(axis) > 0);
    move.kind = counterclockwise ? MoveKind::arc_ccw : MoveKind::arc_cw;
    move.center_mm = luaL_checknumber(state, 3) * basis.first + luaL_checknumber(state, 4) * basis.second;
    move.sweep_rad = luaL_checknumber(state, 5);
    move.target = check_axes(state, interpreter, 6);
    move.feed = check_feed(state, 7, move.sweep_rad);
    move.location = check_location(state, 8);
    interpreter.check(state, interpreter.simulator().moves().enqueue(move));
    return 0;
}

/// core.arc_via(via, target, sweep_rad): an arc through a point.
int arc_via(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    simulation::ViaMove move;
    move.via = check_axes(state, interpreter, 1);
    move.target = check_axes(state, interpreter, 2);
    move.feed = interpreter.feed(state, luaL_checknumber(state, 3));
    move.location = interpreter.location();
    interpreter.check(state, interpreter.simulator().moves().enqueue(move));
    return 0;
}

int dwell(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    const double seconds = luaL_checknumber(state, 1);
    if (!(seconds >= 0) || !std::isfinite(seconds))
        interpreter.alarm(state, DiagnosticKind::word_value,
                          fmt::format("a dwell must be 0 seconds or more, not {:.10g}", seconds));
    interpreter.check(state, interpreter.simulator().dwells().enqueue(seconds, check_location(state, 2)));
    return 0;
}

/// core.event(kind, detail, place, "at_standstill" | "in_passing" | "with_motion")
int event(lua_State* state) {
    static constexpr std::array<const char*, 4> kTimings{"at_rest", "in_passing", "with_motion", nullptr};
    Interpreter& interpreter = bound_interpreter(state);
    interpreter.simulator().events().add(
        luaL_checkstring(state, 1), luaL_optstring(state, 2, ""), check_location(state, 3),
        static_cast<simulation::EventTiming>(check_option(state, 4, "at_rest", kTimings)));
    return 0;
}

/// core.exact_stop_once(): the next move ends in an exact stop.
int exact_stop_once(lua_State* state) {
    bound_interpreter(state).simulator().program().settings().exact_stop_once();
    return 0;
}

/// core.take_time(s, key, place): the machine is at standstill for something that a word has started.
int dwell_for_word(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    const double seconds = luaL_checknumber(state, 1);
    const std::string key = luaL_checkstring(state, 2);
    interpreter.check(
        state, interpreter.simulator().dwells().enqueue_for_word(seconds, key, check_location(state, 3)));
    return 0;
}

/// core.wait(): the controller reads on when all moves have been made.
int wait(lua_State* state) {
    bound_interpreter(state).simulator().clock().wait();
    return 0;
}

/// core.set_spindle_speed(rev_min): for what follows, in the order of the moves.
int set_spindle_speed(lua_State* state) {
    bound_interpreter(state).simulator().program().settings().set_spindle_speed(luaL_checknumber(state, 1));
    return 0;
}

/// core.select_work_offset(name, origin by letter, rotation_deg, moved)
int select_work_offset(lua_State* state) {
    simulation::WorkOffset offset;
    offset.name = luaL_checkstring(state, 1);
    luaL_checktype(state, 2, LUA_TTABLE);
    for (lua_pushnil(state); lua_next(state, 2) != 0; lua_pop(state, 1)) {
        luaL_argcheck(state, lua_type(state, -2) == LUA_TSTRING, 2, "axis letters are expected");
        const int axis = bound_interpreter(state).axis(*lua_tostring(state, -2));
        if (axis < 0) continue;
        const auto& axes = bound_interpreter(state).simulator().machine().axes;
        offset.origin[axes[static_cast<std::size_t>(axis)].letter] = luaL_checknumber(state, -1);
    }
    offset.rotation_deg = luaL_optnumber(state, 3, 0);
    offset.moved = lua_toboolean(state, 4) != 0;
    bound_interpreter(state).simulator().program().work_offsets().select(offset);
    return 0;
}

/// core.lock_overrides(feed, rapid, spindle): the operator's overrides that the moves that follow do not
/// obey.
int lock_overrides(lua_State* state) {
    const auto is_locked = [state](int index) { return lua_toboolean(state, index) != 0; };
    bound_interpreter(state).simulator().program().settings().lock_overrides(
        {.feed = is_locked(1), .rapid = is_locked(2), .spindle = is_locked(3)});
    return 0;
}

/// core.set_path_mode("exact_stop" | "exact_path" | "continuous", tolerance_mm, merge_tolerance_mm)
int set_path_mode(lua_State* state) {
    static constexpr std::array<const char*, 4> kNames{"exact_stop", "exact_path", "continuous", nullptr};
    const auto mode = static_cast<rrs::PathMode>(check_option(state, 1, nullptr, kNames));
    bound_interpreter(state).simulator().program().settings().set_path_mode(mode, luaL_optnumber(state, 2, 0),
                                                                            luaL_optnumber(state, 3, 0));
    return 0;
}

/// core.set_ramps("machine" | "linear" | "s_curve" | "infinite")
int set_ramps(lua_State* state) {
    static constexpr std::array<const char*, 5> kNames{"machine", "linear", "s_curve", "infinite", nullptr};
    bound_interpreter(state).simulator().program().ramps().set_mode(
        static_cast<rrs::RampMode>(check_option(state, 1, nullptr, kNames)));
    return 0;
}

/// core.set_ramp_limits("acceleration" | "deceleration" | "jerk", values by letter)
int set_ramp_limits(lua_State* state) {
    static constexpr std::array<const char*, 4> kNames{"acceleration", "deceleration", "jerk", nullptr};
    const auto limit = static_cast<rrs::RampLimit>(check_option(state, 1, nullptr, kNames));
    luaL_checktype(state, 2, LUA_TTABLE);
    std::map<int, double> values;  // in the order of the axes, which that of a table is not
    for (lua_pushnil(state); lua_next(state, 2) != 0; lua_pop(state, 1)) {
        luaL_argcheck(state, lua_type(state, -2) == LUA_TSTRING, 2, "axis letters are expected");
        const int axis = bound_interpreter(state).axis(*lua_tostring(state, -2));
        luaL_argcheck(state, axis >= 0, 2, "unknown axis");
        values[axis] = luaL_checknumber(state, -1);
    }
    for (const auto& [axis, value] : values)
        bound_interpreter(state).simulator().program().ramps().set_limit(limit, axis, value);
    return 0;
}

/// core.reset_ramp_limits(): those of the machine.
int reset_ramp_limits(lua_State* state) {
    bound_interpreter(state).simulator().program().ramps().reset_limits();
    return 0;
}

/// core.set_path_limits{ speed=, acceleration=, square_corner_velocity=, minimum_cruise_ratio= }: of the path
/// in the moves that follow, mm and s; omitted values stay.
int set_path_limits(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    const auto field = [state](const char* name) {
        std::optional<double> value;
        if (lua_getfield(state, 1, name) != LUA_TNIL) value = luaL_checknumber(state, -1);
        lua_pop(state, 1);
        return value;
    };
    bound_interpreter(state).simulator().program().settings().set_path_limits(
        {.speed_mm_s = field("speed"),
         .acceleration_mm_s2 = field("acceleration"),
         .square_corner_velocity_mm_s = field("square_corner_velocity"),
         .minimum_cruise_ratio = field("minimum_cruise_ratio")});
    return 0;
}

}  // namespace

void add_moves(lua_State* state, Interpreter& interpreter) {
    set_function<consume_feed>(state, "take_feed", &interpreter);
    set_function<feed_mm_min>(state, "feed_mm_min", &interpreter);
    set_function<location>(state, "place", &interpreter);
    set_function<rapid_to>(state, "rapid_to", &interpreter);
    set_function<line_to>(state, "line_to", &interpreter);
    set_function<probe>(state, "probe", &interpreter);
    set_function<joint_to>(state, "joint_to", &interpreter);
    set_function<arc>(state, "arc", &interpreter);
    set_function<arc_via>(state, "arc_via", &interpreter);
    set_function<dwell>(state, "dwell", &interpreter);
    set_function<event>(state, "event", &interpreter);
    set_function<exact_stop_once>(state, "exact_stop_once", &interpreter);
    set_function<wait>(state, "wait", &interpreter);
    set_function<dwell_for_word>(state, "take_time", &interpreter);
    set_function<set_spindle_speed>(state, "set_spindle_speed", &interpreter);
    set_function<select_work_offset>(state, "select_work_offset", &interpreter);
    set_function<lock_overrides>(state, "lock_overrides", &interpreter);
    set_function<set_path_mode>(state, "set_path_mode", &interpreter);
    set_function<set_ramps>(state, "set_ramps", &interpreter);
    set_function<set_ramp_limits>(state, "set_ramp_limits", &interpreter);
    set_function<set_path_limits>(state, "set_path_limits", &interpreter);
    set_function<reset_ramp_limits>(state, "reset_ramp_limits", &interpreter);
}

}  // namespace gsim::script
