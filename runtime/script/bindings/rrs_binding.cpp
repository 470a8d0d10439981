#include <string>

#include "runtime/script/bindings/bindings.h"
#include "runtime/script/bindings/service_binding.h"
#include "runtime/script/lua/lua_state.h"

// Services as scripts call them: each returns the status first, then the results of the service. A target
// that a script itself enqueues is recorded at the script's line as a rapid or linear move, by the active
// motion type.

namespace gsim::script {

using rrs::Shell;
using rrs::Status;

namespace {

struct Target {
    rrs::CartPos pose = rrs::CartPos::Identity();
    rrs::JointPos joints;
};

/// Returns a target: a list of joint values, or a pose.
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

template <auto method>
int service(lua_State* state) {
    return call_service(state, method);
}

/// True for services that no script may call: they are extensions for the words of programs, which call them
/// through the simulator.
template <auto method>
inline constexpr bool kForWordsOnly = false;
template <>
inline constexpr bool kForWordsOnly<&Shell::SetNextArcTarget> = true;
template <>
inline constexpr bool kForWordsOnly<&Shell::SetPathMode> = true;
template <>
inline constexpr bool kForWordsOnly<&Shell::SetNextRest> = true;
template <>
inline constexpr bool kForWordsOnly<&Shell::GetTargetOfLastStep> = true;
template <>
inline constexpr bool kForWordsOnly<&Shell::SetTipControl> = true;
template <>
inline constexpr bool kForWordsOnly<&Shell::ComeToRest> = true;

// Services that scripts call in a special form, or that need more than a response of the controller.

template <>
int service<&Shell::Initialize>(lua_State* state) {  // the run has opened the session
    return push_status(state, Status::RRS_SUCCESS);
}

template <>
int service<&Shell::Reset>(lua_State* state) {  // the run owns it
    return push_status(state, Status::RRS_SERVICE_NOT_SUPPORTED);
}

template <>
int service<&Shell::Terminate>(lua_State* state) {
    return push_status(state, Status::RRS_SERVICE_NOT_SUPPORTED);
}

template <>
int service<&Shell::GetMessage>(lua_State* state) {
    std::string message;
    const Status status = bound_shell(state).GetMessage(message);
    push_status(state, status);
    lua_pushlstring(state, message.data(), message.size());
    return 2;
}

template <>
int service<&Shell::GetInverseKinematics>(lua_State* state) {
    rrs::JointPos joints;
    const rrs::JointPos near = lua_isnoneornil(state, 2)
                                   ? bound_interpreter(state).simulator().motion().source().position()
                                   : check_joints(state, 2, joint_count(state));
    const Status status = bound_shell(state).GetInverseKinematics(check_pose(state, 1), near, joints);
    return push_status(state, status, joints);
}

template <>
int service<&Shell::GetCellFrame>(lua_State* state) {
    rrs::CartPos frame;
    const Status status =
        bound_interpreter(state).simulator().cell().get_frame(luaL_checkstring(state, 1), frame);
    return push_status(state, status, frame);
}

template <>
int service<&Shell::ModifyCellFrame>(lua_State* state) {
    return push_status(state, bound_interpreter(state).simulator().cell().modify_frame(
                                  luaL_checkstring(state, 1), check_pose(state, 2)));
}

template <>
int service<&Shell::SetInitialPosition>(lua_State* state) {
    const Target target = check_target(state, 1);
    return push_status(state, bound_interpreter(state).simulator().services().set_start([&] {
        return bound_shell(state).SetInitialPosition(target.pose, target.joints, {});
    }));
}

/// rrs.SetNextTarget(target [, "via"]) and rrs.SetNextNamedTarget(target, name).
int queue(lua_State* state, rrs::TargetParam param, const std::string& name) {
    Interpreter& interpreter = bound_interpreter(state);
    interpreter.locate(state);
    const Target target = check_target(state, 1);
    const auto call = [&](rrs::TargetId id) {
        return bound_shell(state).SetNextNamedTarget(id, param, target.pose, target.joints, {}, 0, name);
    };
    if (param == rrs::TargetParam::via) return push_status(state, call(0));
    const Status status = interpreter.simulator().services().queue_target(simulation::MoveKind::linear,
                                                                          interpreter.location(), call);
    LuaState::of(state).restart_steps();
    return push_status(state, status);
}

template <>
int service<&Shell::SetNextTarget>(lua_State* state) {
    static const char* const kParams[] = {"end", "via", nullptr};
    return queue(state, static_cast<rrs::TargetParam>(check_option(state, 2, "end", kParams)), {});
}

template <>
int service<&Shell::SetNextNamedTarget>(lua_State* state) {
    return queue(state, rrs::TargetParam::end, luaL_checkstring(state, 2));
}

template <>
int service<&Shell::CancelMotion>(lua_State* state) {
    return push_status(state, bound_interpreter(state).simulator().services().cancel_motion());
}

template <>
int service<&Shell::SelectTracking>(lua_State* state) {
    return push_status(state, bound_interpreter(state).simulator().services().select_tracking(
                                  Arguments(state).next<int>(), lua_toboolean(state, 2) != 0));
}

template <>
int service<&Shell::SetObjectNextTarget>(lua_State* state) {
    return push_status(state, bound_shell(state).SetObjectNextTarget(0, check_pose(state, 1)));
}

/// rrs.status_name(status)
int status_name(lua_State* state) {
    const std::string_view name = rrs::name(static_cast<Status>(Arguments(state).next<int>()));
    lua_pushlstring(state, name.data(), name.size());
    return 1;
}

template <auto method>
void add_service(lua_State* state, Interpreter& interpreter, const char* name) {
    if constexpr (!kForWordsOnly<method>) {
        lua_pushlightuserdata(state, &interpreter);
        lua_pushcclosure(state, trampoline<service<method>>, 1);
        lua_setfield(state, -2, name);
    }
}

}  // namespace

void add_rrs(lua_State* state, Interpreter& interpreter) {
#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, statuses, parameters, arguments) \
    add_service<&Shell::method>(state, interpreter, #method);
#include "controller/module/rcs_services.def"
    lua_pushcfunction(state, trampoline<status_name>);
    lua_setfield(state, -2, "status_name");
}

}  // namespace gsim::script
