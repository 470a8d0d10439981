#include <fmt/format.h>

#include "base/units.h"
#include "motion/kinematics/pose.h"
#include "runtime/script/bindings/bindings.h"
#include "runtime/script/lua/axis_table.h"
#include "runtime/script/lua/group_table.h"
#include "runtime/script/lua/lua_state.h"

namespace gsim::script {

using text::DiagnosticKind;

namespace {

/// {x=, y=, z=, roll=, pitch=, yaw=} in mm and degrees.
rrs::CartPos check_rpy_pose(lua_State* state, int index) {
    luaL_checktype(state, index, LUA_TTABLE);
    kinematics::Rpy pose;
    pose.x_mm = number_field(state, index, "x");
    pose.y_mm = number_field(state, index, "y");
    pose.z_mm = number_field(state, index, "z");
    pose.roll_rad = number_field(state, index, "roll") * kRadPerDeg;
    pose.pitch_rad = number_field(state, index, "pitch") * kRadPerDeg;
    pose.yaw_rad = number_field(state, index, "yaw") * kRadPerDeg;
    return kinematics::pose_from_rpy(pose);
}

/// core.pose_axes{x=, y=, z=, roll=, pitch=, yaw=}: axis values that bring the tool to a pose in mm and
/// degrees; groups of axes, by their names, are at the pose's values, or else at their current ones.
int pose_axes(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    const auto axes = interpreter.simulator().poses().solve_axes(check_rpy_pose(state, 1),
                                                                 check_group_targets(state, interpreter, 1));
    if (!axes) interpreter.alarm(state, DiagnosticKind::unreachable, axes.error());
    interpreter.simulator().poses().warn_if_singular(*axes, interpreter.location());
    push_axes(state, interpreter, *axes);
    return 1;
}

/// core.pose_move(pose, via or nil): moves the tool in a line, or by the pose `via` in an arc, with
/// superimposed groups of axes.
int pose_move(lua_State* state) {
    Interpreter& interpreter = bound_interpreter(state);
    simulation::PoseMove move;
    move.target = check_rpy_pose(state, 1);
    move.groups = check_group_targets(state, interpreter, 1);
    if (!lua_isnoneornil(state, 2)) move.via = check_rpy_pose(state, 2);
    move.feed = interpreter.feed(state, move.via ? std::optional(1.0) : std::nullopt);
    move.location = interpreter.location();
    interpreter.check(state, interpreter.simulator().moves().enqueue(move));
    return 0;
}

/// core.tip_turns(): true if a line of the axes between two poses is not one of the tool.
int rotary_joints_move_tcp(lua_State* state) {
    lua_pushboolean(state,
                    static_cast<int>(bound_interpreter(state).simulator().poses().rotary_joints_move_tcp()));
    return 1;
}

}  // namespace

void add_poses(lua_State* state, Interpreter& interpreter) {
    set_function<pose_axes>(state, "pose_axes", &interpreter);
    set_function<pose_move>(state, "pose_move", &interpreter);
    set_function<rotary_joints_move_tcp>(state, "tip_turns", &interpreter);
}

}  // namespace gsim::script
