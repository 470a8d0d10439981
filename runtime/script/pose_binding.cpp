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
    controller.simulator().warn_if_singular(*axes, controller.place());
    push_axes(state, controller, *axes);
    return 1;
}

}  // namespace

void add_poses(lua_State* state, Controller& controller) {
    set_function<pose_axes>(state, "pose_axes", &controller);
}

}  // namespace gsim::script
