#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "runtime/script/bindings/bindings.h"
#include "runtime/script/lua/axis_table.h"
#include "runtime/script/lua/lua_state.h"

namespace gsim::script {

using text::DiagnosticKind;

using simulation::AxisVector;

namespace {

/// Words of a list, each between two blanks (" i j "), whatever their values.
class WordList final : public NonAxisWords {
  public:
    explicit WordList(std::string_view list) : list_(list) {}
    bool accept_word(std::string_view name, double) override {
        return list_.find(fmt::format(" {} ", name)) != std::string_view::npos;
    }
    std::vector<std::string_view> names() const override {
        std::vector<std::string_view> names;
        for (std::size_t begin = 1; begin < list_.size(); begin = list_.find(' ', begin) + 1)
            names.push_back(list_.substr(begin, list_.find(' ', begin) - begin));
        return names;
    }

  private:
    std::string_view list_;
};

int check_axis(lua_State* state, int argument) {
    const std::string_view letter = luaL_checkstring(state, argument);
    const int axis = letter.size() == 1 ? bound_interpreter(state).axis(letter[0]) : -1;
    luaL_argcheck(state, axis >= 0, argument, "not an axis of the machine");
    return axis;
}

// A controller changes its frames once the moves so far have been made, because it has planned them in the
// old ones.
int set_offset(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    if (interpreter.frame().set_offset(check_axis(state, 1), luaL_checknumber(state, 2)))
        interpreter.simulator().clock().wait();
    return 0;
}

/// core.set_word_factor(letter, factor): number of program units for 1 in a word of the axis.
int set_word_factor(lua_State* state) {
    bound_interpreter(state).set_word_factor(check_axis(state, 1), luaL_checknumber(state, 2));
    return 0;
}

int word_factor(lua_State* state) {
    lua_pushnumber(state, bound_interpreter(state).word_factor(check_axis(state, 1)));
    return 1;
}

/// core.has_matrix(): true if a rotation, scaling or mirror image is active.
int has_matrix(lua_State* state) {
    lua_pushboolean(state, static_cast<int>(bound_interpreter(state).frame().has_matrix()));
    return 1;
}

/// core.set_matrix(nil or {nine numbers, row by row})
int set_matrix(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    if (interpreter.frame().has_matrix() || !lua_isnoneornil(state, 1))
        interpreter.simulator().clock().wait();
    if (lua_isnoneornil(state, 1)) {
        interpreter.frame().set_matrix(std::nullopt);
        return 0;
    }
    luaL_checktype(state, 1, LUA_TTABLE);
    Eigen::Matrix3d matrix;
    for (int i = 0; i < 9; ++i) {
        lua_rawgeti(state, 1, i + 1);
        matrix(i / 3, i % 3) = luaL_checknumber(state, -1);
        lua_pop(state, 1);
    }
    if (!interpreter.frame().set_matrix(matrix))
        interpreter.alarm(state, DiagnosticKind::frame,
                          "a scale of 0 is not allowed, because it reduces the program to a point");
    return 0;
}

int machine_frame_once(lua_State* state) {
    bound_interpreter(state).modal().machine_frame_once = true;
    return 0;
}

/// core.in_machine_frame(): true if G53 holds for the move of this block.
int in_machine_frame(lua_State* state) {
    lua_pushboolean(state, static_cast<int>(bound_interpreter(state).modal().machine_frame_once));
    return 1;
}

int position(lua_State* state) {
    lua_pushnumber(state, bound_interpreter(state).programmed()[check_axis(state, 1)]);
    return 1;
}

int machine_position(lua_State* state) {
    lua_pushnumber(state, bound_interpreter(state).simulator().position().axes()[check_axis(state, 1)]);
    return 1;
}

/// core.turned(letter, value): position of an axis that is sent to `value` in machine coordinates; for a
/// rotary one it may be some turns off.
int turned(lua_State* state) {
    const Interpreter& interpreter = bound_interpreter(state);
    const int axis = check_axis(state, 1);
    const machine::Axis& moved = interpreter.simulator().machine().axes[static_cast<std::size_t>(axis)];
    lua_pushnumber(
        state, machine::rotary_target(moved, luaL_checknumber(state, 2), interpreter.programmed()[axis], 0));
    return 1;
}

/// core.reading(letter, value): value that the axis shows at `value` in machine coordinates.
int reading(lua_State* state) {
    const auto axis = static_cast<std::size_t>(check_axis(state, 1));
    lua_pushnumber(state, machine::reading(bound_interpreter(state).simulator().machine().axes[axis],
                                           luaL_checknumber(state, 2)));
    return 1;
}

int set_programmed(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    if (lua_isnoneornil(state, 1)) {
        interpreter.set_programmed(std::nullopt);
    } else {
        interpreter.set_programmed(check_axes(state, interpreter, 1));
    }
    return 0;
}

/// core.target(words, others): machine coordinates of all axes at the end of the move, and true if any axis
/// is named.
int target(lua_State* state) {
    AxisVector values;
    const std::string_view list = luaL_optstring(state, 2, "");
    WordList others(list);
    const bool any = bound_interpreter(state).read_target(state, 1, list.empty() ? nullptr : &others, values);
    push_axes(state, bound_interpreter(state), values);
    lua_pushboolean(state, static_cast<int>(any));
    return 2;
}

/// core.to_program(target): program coordinates in mm and deg of a point in machine coordinates.
int to_program(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    push_axes(state, interpreter, interpreter.frame().to_program(check_axes(state, interpreter, 1)));
    return 1;
}

/// core.to_machine(values): the reverse; axes that are not named stay unchanged.
int to_machine(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    const ProgramFrame& frame = interpreter.frame();
    const AxisVector values = check_axes(state, interpreter, 1, frame.to_program(interpreter.programmed()));
    push_axes(state, interpreter, frame.to_machine(values));
    return 1;
}

/// core.on_polar(function): turns words with `radius` and `angle` into Cartesian ones.
int set_on_polar(lua_State* state) {
    luaL_checktype(state, 1, LUA_TFUNCTION);
    lua_settop(state, 1);
    bound_interpreter(state).on_polar = luaL_ref(state, LUA_REGISTRYINDEX);
    return 0;
}

/// core.direction(x, y, z): a vector of the program in machine coordinates.
int direction(lua_State* state) {
    const Eigen::Vector3d vector = bound_interpreter(state).frame().direction(
        {luaL_optnumber(state, 1, 0), luaL_optnumber(state, 2, 0), luaL_optnumber(state, 3, 0)});
    for (const double part : vector) lua_pushnumber(state, part);
    return 3;
}

/// core.set_tip_control(nil or offsets by letter in mm): TCP control.
int set_tcp_control(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    std::optional<Eigen::Vector3d> offset;
    if (!lua_isnoneornil(state, 1)) {
        luaL_checktype(state, 1, LUA_TTABLE);
        offset.emplace();
        for (int i = 0; i < 3; ++i) {
            lua_getfield(state, 1, std::array{"x", "y", "z"}[static_cast<std::size_t>(i)]);
            (*offset)[i] = luaL_optnumber(state, -1, 0);
            lua_pop(state, 1);
        }
    }
    interpreter.check(state, interpreter.simulator().tcp_control().set(offset, interpreter.location()));
    return 0;
}

/// core.tip_control(): true if it is on.
int tcp_control(lua_State* state) {
    lua_pushboolean(state, static_cast<int>(bound_interpreter(state).simulator().tcp_control().is_on()));
    return 1;
}

}  // namespace

void add_frames(lua_State* state, Interpreter& interpreter) {
    set_function<set_offset>(state, "set_offset", &interpreter);
    set_function<set_word_factor>(state, "set_word_factor", &interpreter);
    set_function<word_factor>(state, "word_factor", &interpreter);
    set_function<has_matrix>(state, "has_matrix", &interpreter);
    set_function<set_matrix>(state, "set_matrix", &interpreter);
    set_function<machine_frame_once>(state, "machine_frame_once", &interpreter);
    set_function<in_machine_frame>(state, "in_machine_frame", &interpreter);
    set_function<position>(state, "position", &interpreter);
    set_function<machine_position>(state, "machine_position", &interpreter);
    set_function<turned>(state, "turned", &interpreter);
    set_function<reading>(state, "reading", &interpreter);
    set_function<set_programmed>(state, "set_programmed", &interpreter);
    set_function<target>(state, "target", &interpreter);
    set_function<to_program>(state, "to_program", &interpreter);
    set_function<to_machine>(state, "to_machine", &interpreter);
    set_function<set_on_polar>(state, "on_polar", &interpreter);
    set_function<direction>(state, "direction", &interpreter);
    set_function<set_tcp_control>(state, "set_tip_control", &interpreter);
    set_function<tcp_control>(state, "tip_control", &interpreter);
}

}  // namespace gsim::script
