#include <numbers>

#include <fmt/format.h>

#include "runtime/kinematics/pose.h"
#include "runtime/script/axis_table.h"
#include "runtime/script/bindings.h"
#include "runtime/script/lua_state.h"

namespace gsim::script {

namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;

Controller& self(lua_State* state) {
    return bound<Controller>(state);
}

double field(lua_State* state, int index, const char* name) {
    lua_getfield(state, index, name);
    const double value = luaL_optnumber(state, -1, 0);
    lua_pop(state, 1);
    return value;
}

/// {x=, y=, z=, roll=, pitch=, yaw=} in mm and degrees.
rrs::CartPos check_pose(lua_State* state, int index) {
    luaL_checktype(state, index, LUA_TTABLE);
    kinematics::Rpy pose;
    pose.x_mm = field(state, index, "x");
    pose.y_mm = field(state, index, "y");
    pose.z_mm = field(state, index, "z");
    pose.roll_rad = field(state, index, "roll") * kRadPerDeg;
    pose.pitch_rad = field(state, index, "pitch") * kRadPerDeg;
    pose.yaw_rad = field(state, index, "yaw") * kRadPerDeg;
    return kinematics::pose_from_rpy(pose);
}

/// core.pose_axes{x=, y=, z=, roll=, pitch=, yaw=}: axis values that bring the tool to a pose in mm and
/// degrees.
int pose_axes(lua_State* state) {
    Controller& controller = self(state);
    const tl::expected<simulation::AxisVector, std::string> axes =
        controller.simulator().axes_of(check_pose(state, 1));
    if (!axes) controller.alarm(state, axes.error());
    controller.simulator().warn_if_singular(*axes, controller.place());
    push_axes(state, controller, *axes);
    return 1;
}

/// core.pose_move(pose, via or nil): the tool in a line, or by the pose `via` in an arc.
int pose_move(lua_State* state) {
    Controller& controller = self(state);
    simulation::PoseMove move;
    move.target = check_pose(state, 1);
    if (!lua_isnoneornil(state, 2)) move.via = check_pose(state, 2);
    move.feed = controller.feed(state, move.via ? std::optional(1.0) : std::nullopt);
    move.place = controller.place();
    controller.check(state, controller.simulator().move(move));
    return 0;
}

/// core.tip_turns(): whether a line of the axes between two poses is none of the tool.
int tip_turns(lua_State* state) {
    lua_pushboolean(state, static_cast<int>(self(state).simulator().tip_turns()));
    return 1;
}

}  // namespace

void add_poses(lua_State* state, Controller& controller) {
    set_function<pose_axes>(state, "pose_axes", &controller);
    set_function<pose_move>(state, "pose_move", &controller);
    set_function<tip_turns>(state, "tip_turns", &controller);
}

}  // namespace gsim::script
