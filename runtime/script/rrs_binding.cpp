#include <array>
#include <string>

#include "runtime/script/bindings.h"
#include "runtime/script/choice.h"
#include "runtime/script/lua_state.h"
#include "runtime/script/pose_table.h"

// The services as scripts call them: each returns the status first, then what the service gives. A target
// that a script queues itself is recorded at the script's line as a rapid or linear move, by the motion type
// in force.

namespace gsim::script {

using rrs::Shell;
using rrs::Status;

namespace {

Shell& shell(lua_State* state) {
    controller_of(state).attach(state);
    return controller_of(state).simulator().controller();
}

std::size_t joint_count(lua_State* state) {
    return controller_of(state).simulator().machine().axes.size();
}

int answer(lua_State* state, Status status) {
    lua_pushinteger(state, static_cast<lua_Integer>(status));
    return 1;
}

std::string_view text(lua_State* state, int index) {
    return luaL_checkstring(state, index);
}

int whole(lua_State* state, int index) {
    return static_cast<int>(luaL_checkinteger(state, index));
}

/// A list of numbers, or one number for all.
std::vector<double> numbers(lua_State* state, int index, std::size_t count) {
    if (lua_isnumber(state, index) != 0) return std::vector<double>(count, lua_tonumber(state, index));
    const rrs::JointPos values = check_joints(state, index, count);
    return {values.begin(), values.end()};
}

struct Target {
    rrs::CartPos pose = rrs::CartPos::Identity();
    rrs::JointPos joints;
};

/// A target: a list of joint values, or a pose.
Target check_target(lua_State* state, int index) {
    Target target;
    luaL_checktype(state, index, LUA_TTABLE);
    target.joints = rrs::JointPos::Zero(static_cast<Eigen::Index>(joint_count(state)));
    lua_rawgeti(state, index, 1);
    const bool is_pose = lua_istable(state, -1);
    lua_pop(state, 1);
    if (is_pose) {
        target.pose = check_pose(state, index);
    } else {
        target.joints = check_joints(state, index, joint_count(state));
    }
    return target;
}

template <Status (Shell::*Service)()>
int plain(lua_State* state) {
    return answer(state, (shell(state).*Service)());
}

template <Status (Shell::*Service)(double)>
int with_number(lua_State* state) {
    return answer(state, (shell(state).*Service)(luaL_checknumber(state, 1)));
}

template <Status (Shell::*Service)(int)>
int with_integer(lua_State* state) {
    return answer(state, (shell(state).*Service)(whole(state, 1)));
}

template <Status (Shell::*Service)(bool)>
int with_switch(lua_State* state) {
    return answer(state, (shell(state).*Service)(lua_toboolean(state, 1) != 0));
}

template <Status (Shell::*Service)(std::span<const int>, std::span<const double>)>
int with_joints(lua_State* state) {
    return answer(state, (shell(state).*Service)({}, numbers(state, 1, joint_count(state))));
}

int initialize(lua_State* state) {  // the run has opened the session
    return answer(state, Status::RRS_SUCCESS);
}

int owned_by_the_run(lua_State* state) {
    return answer(state, Status::RRS_SERVICE_NOT_SUPPORTED);
}

int get_message(lua_State* state) {
    std::string message;
    const Status status = shell(state).GetMessage(message);
    answer(state, status);
    lua_pushlstring(state, message.data(), message.size());
    return 2;
}

int get_inverse_kinematics(lua_State* state) {
    rrs::JointPos joints;
    const rrs::JointPos near = lua_isnoneornil(state, 2) ? controller_of(state).simulator().joints()
                                                         : check_joints(state, 2, joint_count(state));
    const Status status = shell(state).GetInverseKinematics(check_pose(state, 1), near, joints);
    answer(state, status);
    if (rrs::is_refused(status)) return 1;
    push_joints(state, joints);
    return 2;
}

int get_forward_kinematics(lua_State* state) {
    rrs::CartPos pose;
    const Status status = shell(state).GetForwardKinematics(check_joints(state, 1, joint_count(state)), pose);
    answer(state, status);
    if (rrs::is_refused(status)) return 1;
    push_pose(state, pose);
    return 2;
}

int get_cell_frame(lua_State* state) {
    rrs::CartPos frame;
    const Status status = controller_of(state).simulator().get_cell_frame(text(state, 1), frame);
    answer(state, status);
    if (rrs::is_refused(status)) return 1;
    push_pose(state, frame);
    return 2;
}

int modify_cell_frame(lua_State* state) {
    return answer(state,
                  controller_of(state).simulator().modify_cell_frame(text(state, 1), check_pose(state, 2)));
}

int select_work_frames(lua_State* state) {
    return answer(state, shell(state).SelectWorkFrames(text(state, 1), text(state, 2)));
}

int select_target_type(lua_State* state) {
    static const char* const kNames[] = {"cartesian", "joint", nullptr};
    return answer(state, shell(state).SelectTargetType(
                             static_cast<rrs::TargetType>(check_choice(state, 1, nullptr, kNames))));
}

int select_motion_type(lua_State* state) {
    static const char* const kNames[] = {"joint", "linear", "circular", nullptr};
    static constexpr std::array kTypes = {rrs::MotionType::joint, rrs::MotionType::linear,
                                          rrs::MotionType::circular};
    return answer(state, shell(state).SelectMotionType(
                             kTypes[static_cast<std::size_t>(check_choice(state, 1, nullptr, kNames))]));
}

int select_dominant_interpolation(lua_State* state) {
    static const char* const kNames[] = {"automatic", "position", "orientation", nullptr};
    return answer(state, shell(state).SelectDominantInterpolation(
                             static_cast<rrs::Dominance>(check_choice(state, 1, nullptr, kNames))));
}

int set_initial_position(lua_State* state) {
    const Target target = check_target(state, 1);
    return answer(state, controller_of(state).simulator().set_start([&] {
        return shell(state).SetInitialPosition(target.pose, target.joints, {});
    }));
}

/// rrs.SetNextTarget(target [, "via"]) and rrs.SetNextNamedTarget(target, name).
int queue(lua_State* state, rrs::TargetParam param, const std::string& name) {
    Controller& controller = controller_of(state);
    controller.locate(state);
    const Target target = check_target(state, 1);
    const auto call = [&](rrs::TargetId id) {
        return shell(state).SetNextNamedTarget(id, param, target.pose, target.joints, {}, 0, name);
    };
    if (param == rrs::TargetParam::via) return answer(state, call(0));
    const Status status =
        controller.simulator().queue_target(simulation::MoveKind::linear, controller.place(), call);
    LuaState::of(state).restart_steps();
    return answer(state, status);
}

int set_next_target(lua_State* state) {
    static const char* const kParams[] = {"end", "via", nullptr};
    return queue(state, static_cast<rrs::TargetParam>(check_choice(state, 2, "end", kParams)), {});
}

int set_next_named_target(lua_State* state) {
    return queue(state, rrs::TargetParam::end, luaL_checkstring(state, 2));
}

int get_next_step(lua_State* state) {
    rrs::JointPos joints;
    rrs::CartPos pose;
    double elapsed_s = 0;
    const Status status = shell(state).GetNextStep(joints, pose, elapsed_s);
    answer(state, status);
    if (rrs::is_refused(status)) return 1;
    push_joints(state, joints);
    push_pose(state, pose);
    lua_pushnumber(state, elapsed_s);
    return 4;
}

int set_flyby_criteria_parameter(lua_State* state) {
    return answer(state, shell(state).SetFlybyCriteriaParameter(whole(state, 1), whole(state, 2),
                                                                luaL_checknumber(state, 3)));
}

int set_point_accuracy_parameter(lua_State* state) {
    return answer(state, shell(state).SetPointAccuracyParameter(whole(state, 1), luaL_checknumber(state, 2)));
}

int define_event(lua_State* state) {
    return answer(state, shell(state).DefineEvent(whole(state, 1), luaL_checkinteger(state, 2),
                                                  luaL_checknumber(state, 3)));
}

int get_event(lua_State* state) {
    int event = 0;
    double time_s = 0;
    const Status status = shell(state).GetEvent(whole(state, 1), event, time_s);
    answer(state, status);
    if (rrs::is_refused(status)) return 1;
    lua_pushinteger(state, event);
    lua_pushnumber(state, time_s);
    return 3;
}

int define_path_event(lua_State* state) {
    return answer(state, shell(state).DefinePathEvent(whole(state, 1), luaL_checkinteger(state, 2),
                                                      luaL_checknumber(state, 3)));
}

int cancel_motion(lua_State* state) {
    return answer(state, controller_of(state).simulator().cancel_motion());
}

int set_ramp_mode(lua_State* state) {
    static const char* const kNames[] = {"machine", "linear", "s_curve", "infinite", nullptr};
    return answer(
        state, shell(state).SetRampMode(static_cast<rrs::RampMode>(check_choice(state, 1, nullptr, kNames))));
}

int set_joint_ramp_limits(lua_State* state) {
    static const char* const kNames[] = {"acceleration", "deceleration", "jerk", nullptr};
    const auto limit = static_cast<rrs::RampLimit>(check_choice(state, 1, nullptr, kNames));
    return answer(state, shell(state).SetJointRampLimits(limit, {}, numbers(state, 2, joint_count(state))));
}

int select_tracking(lua_State* state) {
    return answer(state, controller_of(state).simulator().select_tracking(whole(state, 1),
                                                                          lua_toboolean(state, 2) != 0));
}

int set_conveyor_position(lua_State* state) {
    return answer(state, shell(state).SetConveyorPosition(whole(state, 1), luaL_checknumber(state, 2)));
}

/// rrs.DefineConveyor(conveyor, x, y, z, speed_mm_s)
int define_conveyor(lua_State* state) {
    const Eigen::Vector3d direction(luaL_checknumber(state, 2), luaL_checknumber(state, 3),
                                    luaL_checknumber(state, 4));
    return answer(state, shell(state).DefineConveyor(whole(state, 1), direction, luaL_checknumber(state, 5)));
}

int select_object(lua_State* state) {
    return answer(state, shell(state).SelectObject(text(state, 1)));
}

int set_object_initial_position(lua_State* state) {
    return answer(state, shell(state).SetObjectInitialPosition(check_pose(state, 1)));
}

int set_object_next_target(lua_State* state) {
    return answer(state, shell(state).SetObjectNextTarget(0, check_pose(state, 1)));
}

int get_next_object_step(lua_State* state) {
    rrs::CartPos pose;
    double elapsed_s = 0;
    const Status status = shell(state).GetNextObjectStep(pose, elapsed_s);
    answer(state, status);
    if (rrs::is_refused(status)) return 1;
    push_pose(state, pose);
    lua_pushnumber(state, elapsed_s);
    return 3;
}

/// rrs.status_name(status)
int status_name(lua_State* state) {
    const std::string_view name = rrs::name(static_cast<Status>(whole(state, 1)));
    lua_pushlstring(state, name.data(), name.size());
    return 1;
}

constexpr luaL_Reg kServices[] = {
    {"Initialize", trampoline<initialize>},
    {"Reset", trampoline<owned_by_the_run>},
    {"Terminate", trampoline<owned_by_the_run>},
    {"GetMessage", trampoline<get_message>},
    {"GetInverseKinematics", trampoline<get_inverse_kinematics>},
    {"GetForwardKinematics", trampoline<get_forward_kinematics>},
    {"GetCellFrame", trampoline<get_cell_frame>},
    {"ModifyCellFrame", trampoline<modify_cell_frame>},
    {"SelectWorkFrames", trampoline<select_work_frames>},
    {"SelectTargetType", trampoline<select_target_type>},
    {"SelectTrajectoryMode", trampoline<with_integer<&Shell::SelectTrajectoryMode>>},
    {"SetInitialPosition", trampoline<set_initial_position>},
    {"SetNextTarget", trampoline<set_next_target>},
    {"SetNextNamedTarget", trampoline<set_next_named_target>},
    {"GetNextStep", trampoline<get_next_step>},
    {"SetInterpolationTime", trampoline<with_number<&Shell::SetInterpolationTime>>},
    {"SelectMotionType", trampoline<select_motion_type>},
    {"SelectOrientationInterpolationMode",
     trampoline<with_integer<&Shell::SelectOrientationInterpolationMode>>},
    {"SelectDominantInterpolation", trampoline<select_dominant_interpolation>},
    {"SetJointSpeeds", trampoline<with_joints<&Shell::SetJointSpeeds>>},
    {"SetJointAccelerations", trampoline<with_joints<&Shell::SetJointAccelerations>>},
    {"SetJointJerks", trampoline<with_joints<&Shell::SetJointJerks>>},
    {"SetCartesianPositionSpeed", trampoline<with_number<&Shell::SetCartesianPositionSpeed>>},
    {"SetCartesianOrientationSpeed", trampoline<with_number<&Shell::SetCartesianOrientationSpeed>>},
    {"SetCartesianPositionAcceleration", trampoline<with_number<&Shell::SetCartesianPositionAcceleration>>},
    {"SetCartesianOrientationAcceleration",
     trampoline<with_number<&Shell::SetCartesianOrientationAcceleration>>},
    {"SetOverrideSpeed", trampoline<with_number<&Shell::SetOverrideSpeed>>},
    {"SetOverrideAcceleration", trampoline<with_number<&Shell::SetOverrideAcceleration>>},
    {"SelectFlybyMode", trampoline<with_switch<&Shell::SelectFlybyMode>>},
    {"SelectFlybyCriteria", trampoline<with_integer<&Shell::SelectFlybyCriteria>>},
    {"SetFlybyCriteriaParameter", trampoline<set_flyby_criteria_parameter>},
    {"CancelFlybyCriteria", trampoline<with_integer<&Shell::CancelFlybyCriteria>>},
    {"SelectPointAccuracy", trampoline<with_integer<&Shell::SelectPointAccuracy>>},
    {"SetPointAccuracyParameter", trampoline<set_point_accuracy_parameter>},
    {"SetMotionTime", trampoline<with_number<&Shell::SetMotionTime>>},
    {"SetRestParameter", trampoline<with_number<&Shell::SetRestParameter>>},
    {"StopMotion", trampoline<plain<&Shell::StopMotion>>},
    {"ContinueMotion", trampoline<plain<&Shell::ContinueMotion>>},
    {"CancelMotion", trampoline<cancel_motion>},
    {"DefineEvent", trampoline<define_event>},
    {"DefinePathEvent", trampoline<define_path_event>},
    {"CancelEvent", trampoline<with_integer<&Shell::CancelEvent>>},
    {"GetEvent", trampoline<get_event>},
    {"SelectTracking", trampoline<select_tracking>},
    {"SetConveyorPosition", trampoline<set_conveyor_position>},
    {"DefineConveyor", trampoline<define_conveyor>},
    {"SelectObject", trampoline<select_object>},
    {"SetObjectInitialPosition", trampoline<set_object_initial_position>},
    {"SetObjectSpeed", trampoline<with_number<&Shell::SetObjectSpeed>>},
    {"SetObjectNextTarget", trampoline<set_object_next_target>},
    {"GetNextObjectStep", trampoline<get_next_object_step>},
    {"SetRapid", trampoline<with_switch<&Shell::SetRapid>>},
    {"SetRampMode", trampoline<set_ramp_mode>},
    {"SetJointRampLimits", trampoline<set_joint_ramp_limits>},
    {"status_name", trampoline<status_name>},
};

}  // namespace

void add_rrs(lua_State* state, Controller& controller) {
    for (const luaL_Reg& service : kServices) {
        lua_pushlightuserdata(state, &controller);
        lua_pushcclosure(state, service.func, 1);
        lua_setfield(state, -2, service.name);
    }
}

}  // namespace gsim::script
