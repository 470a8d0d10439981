#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/nearest_name.h"
#include "machine/model/machine.h"
#include "runtime/script/bindings/bindings.h"
#include "runtime/script/lua/check_option.h"
#include "runtime/script/lua/group_table.h"
#include "runtime/script/lua/lua_state.h"

namespace gsim::script {

using text::DiagnosticKind;

namespace {

constexpr std::array<const char*, 4> kMotions{"synchronous", "coordinated", "independent",
                                              nullptr};  // of GroupMotion

std::vector<std::string_view> group_names(const machine::Machine& machine) {
    std::vector<std::string_view> names;
    names.reserve(machine.groups.size());
    for (const machine::AxisGroup& group : machine.groups) names.push_back(group.name);
    return names;
}

std::string group_letters(const machine::Machine& machine, const machine::AxisGroup& group) {
    std::string letters;
    for (const std::size_t axis : group.axes) {
        letters += letters.empty() ? "" : ", ";
        letters += static_cast<char>(std::tolower(static_cast<unsigned char>(machine.axes[axis].letter)));
    }
    return letters;
}

bool can_coordinate_groups(const machine::Machine& machine) {
    return machine.inverse == machine::InverseKind::numeric;
}

/// Returns the axis of a group that is named by the key one below the top of the stack.
std::size_t check_group_axis(lua_State* state, Interpreter& interpreter, const machine::AxisGroup& group) {
    const machine::Machine& machine = interpreter.simulator().machine();
    const std::string key = lua_type(state, -2) == LUA_TSTRING ? lua_tostring(state, -2) : "";
    for (const std::size_t axis : group.axes) {
        if (key.size() == 1 && std::toupper(static_cast<unsigned char>(key[0])) == machine.axes[axis].letter)
            return axis;
    }
    interpreter.alarm(state, DiagnosticKind::word_out_of_place,
                      fmt::format("the group '{}' has no axis '{}'; its axes: {}", group.name, key,
                                  group_letters(machine, group)));
}

void read_targets(lua_State* state, Interpreter& interpreter, const machine::AxisGroup& group,
                  std::vector<simulation::GroupTarget>& targets) {
    if (!lua_istable(state, -1)) {
        interpreter.alarm(state, DiagnosticKind::script,
                          fmt::format("the target of a group must be a table of its axes ({}): {} = {{...}}",
                                      group_letters(interpreter.simulator().machine(), group), group.name));
    }
    const std::size_t first = targets.size();
    for (lua_pushnil(state); lua_next(state, -2) != 0; lua_pop(state, 1)) {
        const std::size_t axis = check_group_axis(state, interpreter, group);
        const double value = lua_type(state, -1) == LUA_TNUMBER ? lua_tonumber(state, -1) : NAN;
        if (!std::isfinite(value)) {
            interpreter.alarm(
                state, DiagnosticKind::script,
                fmt::format("the value of an axis of the group '{}' is not a number", group.name));
        }
        targets.push_back({axis, value});
    }
    // Sorts by axis, because a table has no such order.
    std::sort(targets.begin() + static_cast<std::ptrdiff_t>(first), targets.end(),
              [](const auto& a, const auto& b) { return a.axis < b.axis; });
}

std::size_t check_group(lua_State* state, Interpreter& interpreter, int index) {
    const machine::Machine& machine = interpreter.simulator().machine();
    const std::string name = lua_type(state, index) == LUA_TSTRING ? lua_tostring(state, index) : "";
    for (std::size_t i = 0; i < machine.groups.size(); ++i) {
        if (machine.groups[i].name == name) return i;
    }
    const auto names = group_names(machine);
    const auto nearest = text::nearest_name(name, names);
    interpreter.alarm(
        state, DiagnosticKind::machine,
        fmt::format("unknown axis group '{}'; {}", name,
                    nearest         ? fmt::format("did you mean '{}'?", *nearest)
                    : names.empty() ? "groups are defined by tables [[group]] of the machine file"
                                    : fmt::format("known groups: {}", text::joined(names, ", "))));
}

void check_coordinated(lua_State* state, Interpreter& interpreter, const machine::AxisGroup& group) {
    const auto index = static_cast<std::size_t>(&group - interpreter.simulator().machine().groups.data());
    if (interpreter.simulator().groups().motion(index) != machine::GroupMotion::independent) return;
    interpreter.alarm(
        state, DiagnosticKind::mode,
        fmt::format("the group '{0}' is independent; move it with group(\"{0}\").move{{...}}", group.name));
}

/// core.group_names()
int push_group_names(lua_State* state) {
    lua_newtable(state);
    int index = 0;
    for (const machine::AxisGroup& group : bound_interpreter(state).simulator().machine().groups) {
        lua_pushlstring(state, group.name.data(), group.name.size());
        lua_rawseti(state, -2, ++index);
    }
    return 1;
}

/// core.group_motion(name): "synchronous", "coordinated" or "independent".
int group_motion(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    interpreter.locate(state);
    const std::size_t group = check_group(state, interpreter, 1);
    lua_pushstring(state, kMotions[static_cast<std::size_t>(interpreter.simulator().groups().motion(group))]);
    return 1;
}

/// core.set_group_motion(name, motion): for the moves that follow.
int set_group_motion(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    interpreter.locate(state);
    const std::size_t group = check_group(state, interpreter, 1);
    const auto motion = static_cast<machine::GroupMotion>(check_option(state, 2, nullptr, kMotions));
    if (motion == machine::GroupMotion::coordinated &&
        !can_coordinate_groups(interpreter.simulator().machine())) {
        interpreter.alarm(state, DiagnosticKind::mode,
                          "groups are coordinated on machines with inverse = \"numeric\"; if X, Y and Z "
                          "carry the TCP, G43.4 coordinates all axes");
    }
    interpreter.simulator().groups().set_motion(group, motion);
    return 0;
}

/// core.move_group(name, {c = 90}): an independent group moves by itself.
int move_group(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    interpreter.locate(state);
    interpreter.attach(state);
    const std::size_t group = check_group(state, interpreter, 1);
    const machine::AxisGroup& moved = interpreter.simulator().machine().groups[group];
    if (interpreter.simulator().groups().motion(group) != machine::GroupMotion::independent) {
        interpreter.alarm(state, DiagnosticKind::mode,
                          fmt::format("the group '{0}' moves with poses; call group(\"{0}\").independent() "
                                      "before it moves independently",
                                      moved.name));
    }
    lua_settop(state, 2);
    std::vector<simulation::GroupTarget> targets;
    read_targets(state, interpreter, moved, targets);
    interpreter.check(state, interpreter.simulator().groups().move(group, targets, interpreter.location()));
    return 0;
}

/// core.wait_for_groups(): waits until none moves by itself.
int wait_for_groups(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    interpreter.locate(state);
    interpreter.attach(state);
    interpreter.check(state, interpreter.simulator().groups().wait(interpreter.location()));
    return 0;
}

}  // namespace

std::vector<simulation::GroupTarget> check_group_targets(lua_State* state, Interpreter& interpreter,
                                                         int index) {
    std::vector<simulation::GroupTarget> targets;
    const machine::Machine& machine = interpreter.simulator().machine();
    for (const machine::AxisGroup& group : machine.groups) {
        lua_getfield(state, index, group.name.c_str());
        if (!lua_isnil(state, -1)) {
            if (!can_coordinate_groups(machine)) {
                interpreter.alarm(state, DiagnosticKind::mode,
                                  fmt::format("the inverse of this machine calculates the axes of the group "
                                              "'{}'; move them by words such as G1",
                                              group.name));
            }
            check_coordinated(state, interpreter, group);
            read_targets(state, interpreter, group, targets);
        }
        lua_pop(state, 1);
    }
    return targets;
}

void add_groups(lua_State* state, Interpreter& interpreter) {
    set_function<push_group_names>(state, "group_names", &interpreter);
    set_function<group_motion>(state, "group_motion", &interpreter);
    set_function<set_group_motion>(state, "set_group_motion", &interpreter);
    set_function<move_group>(state, "move_group", &interpreter);
    set_function<wait_for_groups>(state, "wait_for_groups", &interpreter);
}

}  // namespace gsim::script
