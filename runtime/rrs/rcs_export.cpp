#include "runtime/rrs/rcs_export.h"

#include <exception>
#include <optional>
#include <utility>

#include "runtime/rrs/rcs_host.h"
#include "runtime/rrs/rcs_values.h"

struct gsim_rcs_module {
    std::unique_ptr<gsim::rrs::Shell> shell;
    std::string trouble;  // of an exception, until it has been told
};

namespace gsim::rrs {

namespace {

/// The answer of a group of services; nothing where the opcode is of another group.
using Answer = std::optional<Status>;

template <typename Value>
const Value& as(const void* input) {
    return *static_cast<const Value*>(input);
}

double number(const void* input) {
    return as<gsim_rcs_number>(input).value;
}

int integer(const void* input) {
    return as<gsim_rcs_integer>(input).value;
}

bool on(const void* input) {
    return integer(input) != 0;
}

template <std::size_t size>
std::string text(const char (&place)[size]) {
    return rcs_text(place, size);
}

/// Answers of services that fill in their output on success.
template <typename Output, typename Value>
Status give(Status status, const Value& value, void* output) {
    if (!is_refused(status)) *static_cast<Output*>(output) = to_rcs(value);
    return status;
}

Answer session(Shell& shell, std::int32_t opcode, void* output) {
    switch (opcode) {
        case GSIM_RCS_INITIALIZE: return shell.Initialize();
        case GSIM_RCS_RESET: return shell.Reset();
        case GSIM_RCS_TERMINATE: return shell.Terminate();
        case GSIM_RCS_STOP_MOTION: return shell.StopMotion();
        case GSIM_RCS_CONTINUE_MOTION: return shell.ContinueMotion();
        case GSIM_RCS_CANCEL_MOTION: return shell.CancelMotion();
        case GSIM_RCS_GET_MESSAGE: {
            std::string message;
            const Status status = shell.GetMessage(message);
            put_text(message, static_cast<gsim_rcs_message*>(output)->text);
            return status;
        }
        default: return std::nullopt;
    }
}

Answer frames(Shell& shell, std::int32_t opcode, const void* input, void* output) {
    CartPos pose;
    JointPos joints;
    switch (opcode) {
        case GSIM_RCS_GET_INVERSE_KINEMATICS: {
            const auto& in = as<gsim_rcs_pose_and_joints>(input);
            const Status status = shell.GetInverseKinematics(from_rcs(in.pose), from_rcs(in.joints), joints);
            return give<gsim_rcs_joints>(status, joints, output);
        }
        case GSIM_RCS_GET_FORWARD_KINEMATICS: {
            const Status status = shell.GetForwardKinematics(from_rcs(as<gsim_rcs_joints>(input)), pose);
            return give<gsim_rcs_pose>(status, pose, output);
        }
        case GSIM_RCS_GET_CELL_FRAME: {
            const Status status = shell.GetCellFrame(text(as<gsim_rcs_frame>(input).name), pose);
            return give<gsim_rcs_pose>(status, pose, output);
        }
        case GSIM_RCS_MODIFY_CELL_FRAME: {
            const auto& in = as<gsim_rcs_frame>(input);
            return shell.ModifyCellFrame(text(in.name), from_rcs(in.pose));
        }
        case GSIM_RCS_SELECT_WORK_FRAMES: {
            const auto& in = as<gsim_rcs_work_frames>(input);
            return shell.SelectWorkFrames(text(in.tool), text(in.object));
        }
        default: return std::nullopt;
    }
}

Status put_target(Shell& shell, const gsim_rcs_target& in, bool named) {
    const auto param = static_cast<TargetParam>(in.param);
    const CartPos pose = from_rcs(in.position.pose);
    const JointPos joints = from_rcs(in.position.joints);
    const std::string configuration = text(in.position.configuration);
    if (!named) return shell.SetNextTarget(in.id, param, pose, joints, configuration, in.param_value);
    return shell.SetNextNamedTarget(in.id, param, pose, joints, configuration, in.param_value, text(in.name));
}

Answer targets(Shell& shell, std::int32_t opcode, const void* input) {
    switch (opcode) {
        case GSIM_RCS_SET_INITIAL_POSITION: {
            const auto& in = as<gsim_rcs_position>(input);
            return shell.SetInitialPosition(from_rcs(in.pose), from_rcs(in.joints), text(in.configuration));
        }
        case GSIM_RCS_SET_NEXT_TARGET: return put_target(shell, as<gsim_rcs_target>(input), false);
        case GSIM_RCS_SET_NEXT_NAMED_TARGET: return put_target(shell, as<gsim_rcs_target>(input), true);
        case GSIM_RCS_SET_NEXT_ARC_TARGET: {
            const auto& in = as<gsim_rcs_arc_target>(input);
            return shell.SetNextArcTarget(in.id, Eigen::Vector3d(in.center_mm), Eigen::Vector3d(in.axis),
                                          in.sweep_rad, from_rcs(in.end.pose), from_rcs(in.end.joints));
        }
        case GSIM_RCS_SET_NEXT_REST: {
            const auto& in = as<gsim_rcs_rest>(input);
            return shell.SetNextRest(in.id, in.rest_s);
        }
        case GSIM_RCS_SET_OBJECT_NEXT_TARGET: {
            const auto& in = as<gsim_rcs_object_target>(input);
            return shell.SetObjectNextTarget(in.id, from_rcs(in.pose));
        }
        default: return std::nullopt;
    }
}

Status take_step(Shell& shell, gsim_rcs_step& out) {
    JointPos joints;
    CartPos pose;
    double elapsed_s = 0;
    const Status status = shell.GetNextStep(joints, pose, elapsed_s);
    if (!is_refused(status)) out = {to_rcs(joints), to_rcs(pose), elapsed_s};
    return status;
}

Status take_object_step(Shell& shell, gsim_rcs_object_step& out) {
    CartPos pose;
    double elapsed_s = 0;
    const Status status = shell.GetNextObjectStep(pose, elapsed_s);
    if (!is_refused(status)) out = {to_rcs(pose), elapsed_s};
    return status;
}

Status take_event(Shell& shell, int which, gsim_rcs_event& out) {
    int event = 0;
    double time_s = 0;
    const Status status = shell.GetEvent(which, event, time_s);
    if (!is_refused(status)) out = {event, 0, time_s};
    return status;
}

Answer steps(Shell& shell, std::int32_t opcode, const void* input, void* output) {
    switch (opcode) {
        case GSIM_RCS_GET_NEXT_STEP: return take_step(shell, *static_cast<gsim_rcs_step*>(output));
        case GSIM_RCS_GET_NEXT_OBJECT_STEP:
            return take_object_step(shell, *static_cast<gsim_rcs_object_step*>(output));
        case GSIM_RCS_GET_EVENT:
            return take_event(shell, integer(input), *static_cast<gsim_rcs_event*>(output));
        case GSIM_RCS_GET_TARGET_OF_LAST_STEP: {
            TargetId id = -1;
            const Status status = shell.GetTargetOfLastStep(id);
            if (!is_refused(status)) *static_cast<gsim_rcs_target_id*>(output) = {id};
            return status;
        }
        case GSIM_RCS_COME_TO_REST: return shell.ComeToRest(static_cast<RestReason>(integer(input)));
        default: return std::nullopt;
    }
}

Answer numbers(Shell& shell, std::int32_t opcode, const void* input) {
    switch (opcode) {
        case GSIM_RCS_SET_INTERPOLATION_TIME: return shell.SetInterpolationTime(number(input));
        case GSIM_RCS_SET_CARTESIAN_POSITION_SPEED: return shell.SetCartesianPositionSpeed(number(input));
        case GSIM_RCS_SET_CARTESIAN_ORIENTATION_SPEED:
            return shell.SetCartesianOrientationSpeed(number(input));
        case GSIM_RCS_SET_CARTESIAN_POSITION_ACCELERATION:
            return shell.SetCartesianPositionAcceleration(number(input));
        case GSIM_RCS_SET_CARTESIAN_ORIENTATION_ACCELERATION:
            return shell.SetCartesianOrientationAcceleration(number(input));
        case GSIM_RCS_SET_OVERRIDE_SPEED: return shell.SetOverrideSpeed(number(input));
        case GSIM_RCS_SET_OVERRIDE_ACCELERATION: return shell.SetOverrideAcceleration(number(input));
        case GSIM_RCS_SET_MOTION_TIME: return shell.SetMotionTime(number(input));
        case GSIM_RCS_SET_REST_PARAMETER: return shell.SetRestParameter(number(input));
        case GSIM_RCS_SET_OBJECT_SPEED: return shell.SetObjectSpeed(number(input));
        default: return std::nullopt;
    }
}

Answer selections(Shell& shell, std::int32_t opcode, const void* input) {
    switch (opcode) {
        case GSIM_RCS_SELECT_TARGET_TYPE:
            return shell.SelectTargetType(static_cast<TargetType>(integer(input)));
        case GSIM_RCS_SELECT_MOTION_TYPE:
            return shell.SelectMotionType(static_cast<MotionType>(integer(input)));
        case GSIM_RCS_SELECT_DOMINANT_INTERPOLATION:
            return shell.SelectDominantInterpolation(static_cast<Dominance>(integer(input)));
        case GSIM_RCS_SELECT_TRAJECTORY_MODE: return shell.SelectTrajectoryMode(integer(input));
        case GSIM_RCS_SELECT_ORIENTATION_INTERPOLATION_MODE:
            return shell.SelectOrientationInterpolationMode(integer(input));
        case GSIM_RCS_SELECT_FLYBY_CRITERIA: return shell.SelectFlybyCriteria(integer(input));
        case GSIM_RCS_CANCEL_FLYBY_CRITERIA: return shell.CancelFlybyCriteria(integer(input));
        case GSIM_RCS_SELECT_POINT_ACCURACY: return shell.SelectPointAccuracy(integer(input));
        case GSIM_RCS_CANCEL_EVENT: return shell.CancelEvent(integer(input));
        case GSIM_RCS_SELECT_FLYBY_MODE: return shell.SelectFlybyMode(on(input));
        case GSIM_RCS_SET_RAPID: return shell.SetRapid(on(input));
        case GSIM_RCS_SET_RAMP_MODE: return shell.SetRampMode(static_cast<RampMode>(integer(input)));
        default: return std::nullopt;
    }
}

template <typename Call>
Status with_joint_values(const gsim_rcs_joint_values& in, const Call& call) {
    const auto in_range = [](std::int32_t count) { return count >= 0 && count <= kMaxJoints; };
    if (!in_range(in.joint_count) || !in_range(in.value_count)) return Status::RRS_INVALID_PARAMETER;
    return call(std::span(in.joints, static_cast<std::size_t>(in.joint_count)),
                std::span(in.values, static_cast<std::size_t>(in.value_count)));
}

Answer joint_values(Shell& shell, std::int32_t opcode, const void* input) {
    const auto set = [&](auto service) {
        return with_joint_values(as<gsim_rcs_joint_values>(input),
                                 [&](auto joints, auto values) { return (shell.*service)(joints, values); });
    };
    switch (opcode) {
        case GSIM_RCS_SET_JOINT_SPEEDS: return set(&Shell::SetJointSpeeds);
        case GSIM_RCS_SET_JOINT_ACCELERATIONS: return set(&Shell::SetJointAccelerations);
        case GSIM_RCS_SET_JOINT_JERKS: return set(&Shell::SetJointJerks);
        case GSIM_RCS_SET_JOINT_RAMP_LIMITS: {
            const auto& in = as<gsim_rcs_ramp_limits>(input);
            return with_joint_values(in.values, [&](auto joints, auto values) {
                return shell.SetJointRampLimits(static_cast<RampLimit>(in.limit), joints, values);
            });
        }
        default: return std::nullopt;
    }
}

Answer parameters(Shell& shell, std::int32_t opcode, const void* input) {
    switch (opcode) {
        case GSIM_RCS_SET_FLYBY_CRITERIA_PARAMETER: {
            const auto& in = as<gsim_rcs_parameter_value>(input);
            return shell.SetFlybyCriteriaParameter(in.number, in.joint, in.value);
        }
        case GSIM_RCS_SET_POINT_ACCURACY_PARAMETER: {
            const auto& in = as<gsim_rcs_parameter_value>(input);
            return shell.SetPointAccuracyParameter(in.number, in.value);
        }
        case GSIM_RCS_SET_CONVEYOR_POSITION: {
            const auto& in = as<gsim_rcs_parameter_value>(input);
            return shell.SetConveyorPosition(in.number, in.value);
        }
        case GSIM_RCS_DEFINE_EVENT: {
            const auto& in = as<gsim_rcs_event_definition>(input);
            return shell.DefineEvent(in.event, in.target, in.offset_s);
        }
        case GSIM_RCS_DEFINE_PATH_EVENT: {
            const auto& in = as<gsim_rcs_path_event_definition>(input);
            return shell.DefinePathEvent(in.event, in.target, in.offset_mm);
        }
        case GSIM_RCS_SELECT_TRACKING: {
            const auto& in = as<gsim_rcs_tracking>(input);
            return shell.SelectTracking(in.conveyor, in.on != 0);
        }
        case GSIM_RCS_SET_PATH_MODE: {
            const auto& in = as<gsim_rcs_path_mode>(input);
            return shell.SetPathMode(static_cast<PathMode>(in.mode), in.tolerance_mm, in.merge_tolerance_mm);
        }
        default: return std::nullopt;
    }
}

Status answer(Shell& shell, std::int32_t opcode, const void* input, void* output) {
    if (const Answer done = session(shell, opcode, output)) return *done;
    if (const Answer done = steps(shell, opcode, input, output)) return *done;
    if (const Answer done = targets(shell, opcode, input)) return *done;
    if (const Answer done = numbers(shell, opcode, input)) return *done;
    if (const Answer done = selections(shell, opcode, input)) return *done;
    if (const Answer done = frames(shell, opcode, input, output)) return *done;
    if (const Answer done = joint_values(shell, opcode, input)) return *done;
    return parameters(shell, opcode, input).value_or(Status::RRS_SERVICE_NOT_SUPPORTED);
}

/// The text of the exception that is being handled.
std::string current_trouble() {
    try {
        throw;
    } catch (const std::exception& error) {
        return error.what();
    } catch (...) {
        return "an exception that is no std::exception";
    }
}

}  // namespace

gsim_rcs_module* create_exported(ShellFactory make, const gsim_rcs_machine* machine,
                                 gsim_rcs_message* message) noexcept {
    try {
        auto shell = make(*machine);
        if (shell) return new gsim_rcs_module{std::move(*shell), {}};
        put_text(shell.error(), message->text);
    } catch (...) {
        put_text(current_trouble(), message->text);
    }
    return nullptr;
}

void destroy_exported(gsim_rcs_module* module) noexcept {
    delete module;
}

std::int32_t call_exported(gsim_rcs_module* module, std::int32_t opcode, const void* input,
                           void* output) noexcept {
    try {
        if (opcode == GSIM_RCS_GET_MESSAGE && !module->trouble.empty()) {
            put_text(std::exchange(module->trouble, {}), static_cast<gsim_rcs_message*>(output)->text);
            return GSIM_RCS_SUCCESS;
        }
        return static_cast<std::int32_t>(answer(*module->shell, opcode, input, output));
    } catch (...) {
        module->trouble = current_trouble();
        return GSIM_RCS_FAULT;
    }
}

}  // namespace gsim::rrs
