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

double field(lua_State* state, const char* name) {
    lua_getfield(state, 1, name);
    const double value = luaL_optnumber(state, -1, 0);
    lua_pop(state, 1);
    return value;
}

/// core.pose_axes{x=, y=, z=, roll=, pitch=, yaw=}: axis values that bring the tool to a pose in mm and
/// degrees.
int pose_axes(lua_State* state) {
    luaL_checktype(state, 1, LUA_TTABLE);
    Controller& controller = self(state);
    kinematics::Rpy pose;
    pose.x_mm = field(state, "x");
    pose.y_mm = field(state, "y");
    pose.z_mm = field(state, "z");
    pose.roll_rad = field(state, "roll") * kRadPerDeg;
    pose.pitch_rad = field(state, "pitch") * kRadPerDeg;
    pose.yaw_rad = field(state, "yaw") * kRadPerDeg;
    const tl::expected<simulation::AxisVector, std::string> axes =
        controller.simulator().axes_of(kinematics::pose_from_rpy(pose));
    if (!axes) controller.alarm(state, axes.error());
    push_axes(state, controller, *axes);
    return 1;
}

simulation::LineMove line_to_target(lua_State* state, Controller& controller) {
    simulation::LineMove move;
    move.target = check_axes(state, controller, 1);
    move.place = controller.place();
    return move;
}

/// core.line_to(target): a feed move to machine coordinates.
int line_to(lua_State* state) {
    Controller& controller = self(state);
    simulation::LineMove move = line_to_target(state, controller);
    move.feed = controller.feed(state, std::nullopt);
    controller.check(state, controller.simulator().move(move));
    return 0;
}

/// core.joint_to(target): all joints together, the slowest at its limits.
int joint_to(lua_State* state) {
    Controller& controller = self(state);
    simulation::LineMove move = line_to_target(state, controller);
    move.rapid = true;
    move.joint = true;
    controller.check(state, controller.simulator().move(move));
    return 0;
}

}  // namespace

void add_poses(lua_State* state, Controller& controller) {
    set_function<pose_axes>(state, "pose_axes", &controller);
    set_function<line_to>(state, "line_to", &controller);
    set_function<joint_to>(state, "joint_to", &controller);
}

}  // namespace gsim::script
