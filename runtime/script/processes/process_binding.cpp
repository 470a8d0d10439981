#include <cmath>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/nearest_name.h"
#include "runtime/script/lua/check_option.h"
#include "runtime/script/processes/processes.h"

// Functions of processes for the Lua library. Functions that wait for other processes yield: their last
// action is to return the result of Processes.

namespace gsim::script {

using text::DiagnosticKind;

namespace {

using process::Value;
using process::WaitKind;

/// Size of a node of a map, without the name.
constexpr std::size_t kBytesOfSignal = 128;

Processes& bound_processes(lua_State* state) {
    return bound<Processes>(state);
}

[[noreturn]] void alarm(lua_State* state, const std::string& message) {
    bound_processes(state).robots().alarm(state, DiagnosticKind::process, message);
}

/// Returns the controller of the calling library.
RobotController& engine_control(lua_State* state) {
    return *static_cast<RobotController*>(lua_touserdata(state, lua_upvalueindex(2)));
}

std::string check_name(lua_State* state, int index, const char* what) {
    std::size_t size = 0;
    const char* text = lua_type(state, index) == LUA_TSTRING ? lua_tolstring(state, index, &size) : nullptr;
    if (text == nullptr || size == 0)
        alarm(state, fmt::format("the name of a {} must be a string that is not empty", what));
    return {text, size};
}

Value check_value(lua_State* state, int index) {
    if (lua_isboolean(state, index)) return lua_toboolean(state, index) != 0;
    const double number = lua_type(state, index) == LUA_TNUMBER ? lua_tonumber(state, index) : NAN;
    if (!std::isfinite(number)) alarm(state, "the value of a signal must be true, false or a finite number");
    return number;
}

void push_value(lua_State* state, const Value& value) {
    if (const auto* number = std::get_if<double>(&value)) {
        lua_pushnumber(state, *number);
    } else {
        lua_pushboolean(state, static_cast<int>(std::get<bool>(value)));
    }
}

double check_seconds(lua_State* state, int index) {
    const double seconds = lua_type(state, index) == LUA_TNUMBER ? lua_tonumber(state, index) : NAN;
    if (!(seconds >= 0) || !std::isfinite(seconds))
        alarm(state, "a wait needs a number of seconds, 0 or more");
    return seconds;
}

template <typename Names>
std::string hint(std::string_view kind, std::string_view name, const Names& names) {
    if (const auto nearest = text::nearest_name(name, names))
        return fmt::format("did you mean '{}'?", *nearest);
    return names.empty() ? fmt::format("{}s are defined in a robots file (--robots)", kind)
                         : fmt::format("available: {}", text::joined(names, ", "));
}

/// Implements join(): continues when no process is earlier.
int join(lua_State* state) {
    return bound_processes(state).join(state);
}

/// Implements rest(): the robot of the process comes to a standstill, and their clocks agree.
int bring_to_standstill(lua_State* state) {
    bound_processes(state).robots().bring_to_standstill(state);
    return 0;
}

int wait_seconds(lua_State* state) {
    return bound_processes(state).wait(state, check_seconds(state, 1));
}

/// Implements start(name, f, background).
int start(lua_State* state) {
    std::string name = check_name(state, 1, "process");
    if (!lua_isfunction(state, 2)) alarm(state, "a process needs a name and a function");
    const bool background = lua_toboolean(state, 3) != 0;
    lua_settop(state, 2);
    bound_processes(state).start(state, std::move(name), background);
    return 0;
}

int signal(lua_State* state) {
    const std::string name = check_name(state, 1, "signal");
    const Value value = check_value(state, 2);
    if (!bound_processes(state).signals().board().has(name))
        LuaState::of(state).add_external_bytes(state, kBytesOfSignal + name.size(),
                                               "the signals of the script");
    bound_processes(state).signals().set(name, value);
    return 0;
}

int value(lua_State* state) {
    push_value(state, bound_processes(state).signals().board().get(check_name(state, 1, "signal")));
    return 1;
}

/// Implements wait_signal(name, how, value, seconds or nil); how is "on", "off", "equals", "rises", "falls"
/// or "any".
int wait_signal(lua_State* state) {
    static const char* const kNames[] = {"on", "off", "equals", "rises", "falls", "any", nullptr};
    process::Wait wait;
    wait.kind = static_cast<WaitKind>(check_option(state, 2, "on", kNames));
    if (wait.kind != WaitKind::any_change) wait.signal = check_name(state, 1, "signal");
    if (wait.kind == WaitKind::equals) wait.value = check_value(state, 3);
    if (!lua_isnoneornil(state, 4)) wait.until_s = bound_processes(state).time_s() + check_seconds(state, 4);
    return bound_processes(state).signals().wait(state, std::move(wait));
}

int on_signal(lua_State* state) {
    const std::string name = check_name(state, 1, "signal");
    lua_settop(state, 2);
    if (!lua_isnil(state, 2) && !lua_isfunction(state, 2))
        alarm(state, "on_signal needs the name of a signal and a function, or nil");
    bound_processes(state).signals().set_interrupt(state, name);
    return 0;
}

/// Implements several(): true if processes exist in addition to the main one.
int several(lua_State* state) {
    lua_pushboolean(state, static_cast<int>(bound_processes(state).several()));
    return 1;
}

int robot(lua_State* state) {
    const std::string name = check_name(state, 1, "robot");
    const RobotController* found = bound_processes(state).robots().find(name);
    if (found == nullptr) {
        alarm(state, fmt::format("unknown robot '{}'; {}", name,
                                 hint("robot", name, bound_processes(state).robots().names())));
    }
    found->push_environment(state);
    return 1;
}

/// Implements time(): the clock of the process.
int process_time(lua_State* state) {
    lua_pushnumber(state, bound_processes(state).time_s());
    return 1;
}

std::size_t check_zone(lua_State* state, int index) {
    const std::string name = check_name(state, index, "zone");
    const process::SharedZones& zones = bound_processes(state).zones().shared_zones();
    if (const auto found = zones.find(name)) return *found;
    alarm(state, fmt::format("unknown zone '{}'; {}", name, hint("zone", name, zones.names())));
}

/// Implements enter_zone(name): continues when the process has the zone.
int enter_zone(lua_State* state) {
    const std::size_t zone = check_zone(state, 1);
    if (bound_processes(state).zones().has(zone)) {
        alarm(state, fmt::format("the process already occupies the zone '{}'",
                                 bound_processes(state).zones().shared_zones().name(zone)));
    }
    return bound_processes(state).zones().enter(state, zone);
}

int leave_zone(lua_State* state) {
    const std::size_t zone = check_zone(state, 1);
    if (!bound_processes(state).zones().has(zone)) {
        alarm(state, fmt::format("the process does not occupy the zone '{}'",
                                 bound_processes(state).zones().shared_zones().name(zone)));
    }
    bound_processes(state).zones().leave(zone);
    return 0;
}

process::Conveyor& check_conveyor(lua_State* state, int index) {
    const std::string name = check_name(state, index, "conveyor");
    process::Conveyor* found = bound_processes(state).conveyors().find(name);
    if (found != nullptr) return *found;
    alarm(state, fmt::format("unknown conveyor '{}'; {}", name,
                             hint("conveyor", name, bound_processes(state).conveyors().names())));
}

/// Implements conveyor(name): raises an alarm if the conveyor does not exist.
int conveyor(lua_State* state) {
    check_conveyor(state, 1);
    return 0;
}

/// Implements conveyor_position(name): mm of travel at the time of the process.
int conveyor_position(lua_State* state) {
    lua_pushnumber(state, check_conveyor(state, 1).position_mm(bound_processes(state).time_s()));
    return 1;
}

/// Implements conveyor_speed(name, mm_s).
int conveyor_speed(lua_State* state) {
    process::Conveyor& conveyor = check_conveyor(state, 1);
    const double speed_mm_s = lua_type(state, 2) == LUA_TNUMBER ? lua_tonumber(state, 2) : NAN;
    if (!std::isfinite(speed_mm_s)) alarm(state, "the speed of a conveyor must be a number in mm/s");
    bound_processes(state).conveyors().set_speed(state, conveyor, speed_mm_s);
    return 0;
}

/// Implements conveyor_reaches(name, mm): seconds from now until it has travelled that far; nil if it never
/// does.
int conveyor_reaches(lua_State* state) {
    const process::Conveyor& conveyor = check_conveyor(state, 1);
    const double position_mm = lua_type(state, 2) == LUA_TNUMBER ? lua_tonumber(state, 2) : NAN;
    if (!std::isfinite(position_mm)) alarm(state, "the position of a conveyor must be a number in mm");
    const double now_s = bound_processes(state).time_s();
    const double arrival_s = conveyor.arrival_time_s(position_mm, now_s);
    if (!std::isfinite(arrival_s)) return 0;
    lua_pushnumber(state, arrival_s - now_s);
    return 1;
}

/// Implements track(name or nil).
int track(lua_State* state) {
    process::Conveyor* requested = lua_isnoneornil(state, 1) ? nullptr : &check_conveyor(state, 1);
    bound_processes(state).conveyors().track(state, engine_control(state), requested);
    return 0;
}

constexpr luaL_Reg kProcessFunctions[] = {
    {"join", trampoline<join>},
    {"rest", trampoline<bring_to_standstill>},
    {"wait", trampoline<wait_seconds>},
    {"start", trampoline<start>},
    {"signal", trampoline<signal>},
    {"value", trampoline<value>},
    {"wait_signal", trampoline<wait_signal>},
    {"on_signal", trampoline<on_signal>},
    {"several", trampoline<several>},
    {"robot", trampoline<robot>},
    {"time", trampoline<process_time>},
    {"conveyor", trampoline<conveyor>},
    {"conveyor_position", trampoline<conveyor_position>},
    {"conveyor_speed", trampoline<conveyor_speed>},
    {"conveyor_reaches", trampoline<conveyor_reaches>},
    {"track", trampoline<track>},
    {"enter_zone", trampoline<enter_zone>},
    {"leave_zone", trampoline<leave_zone>},
};

}  // namespace

void add_processes(lua_State* state, Processes& processes, RobotController& controller) {
    lua_newtable(state);
    for (const luaL_Reg& function : kProcessFunctions) {
        lua_pushlightuserdata(state, &processes);
        lua_pushlightuserdata(state, &controller);
        lua_pushcclosure(state, function.func, 2);
        lua_setfield(state, -2, function.name);
    }
    lua_setfield(state, -2, "processes");
}

}  // namespace gsim::script
