// The services that a controller module is asked for, and the checks of what it answers.

#include "runtime/rrs/rcs_shell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "runtime/rrs/rcs_values.h"

namespace gsim::rrs {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kLargestOfStep = 1e15;  // mm or rad: beyond any target; sums over a run stay finite
constexpr double kStepRounding = 1 + 1e-6;
constexpr double kClockRounding = 1e-12;  // a step is a difference of two instants

// What a module leaves as it is fails the check.
gsim_rcs_pose no_pose() {
    gsim_rcs_pose pose;
    std::fill(std::begin(pose.matrix), std::end(pose.matrix), kNan);
    return pose;
}

gsim_rcs_joints no_joints() {
    gsim_rcs_joints joints;
    joints.count = -1;
    joints.reserved = 0;
    std::fill(std::begin(joints.values), std::end(joints.values), kNan);
    return joints;
}

bool may_answer_step(int answer) {
    return answer == GSIM_RCS_NEED_MORE_DATA || answer == GSIM_RCS_TARGET_REACHED;
}

}  // namespace

Status RcsShell::blame(std::string_view what) {
    if (!fault_) fault_ = fmt::format("The controller module {} {}.", name(), what);
    return Status::RRS_MODULE_FAULT;
}

Status RcsShell::refuse(std::string message) {
    own_message_ = std::move(message);
    return Status::RRS_INVALID_PARAMETER;
}

Status RcsShell::ask(const Service& service, const void* input, void* output, Extra extra) {
    if (fault_) return Status::RRS_MODULE_FAULT;
    calling();
    const int answer = module_.call(service.opcode, input, output);
    if (answer == GSIM_RCS_SUCCESS) return Status::RRS_SUCCESS;
    if (answer == GSIM_RCS_FAULT) {
        gsim_rcs_message message{};
        module_.call(GSIM_RCS_GET_MESSAGE, nullptr, &message);
        return blame(
            fmt::format("failed in {}: {}", service.name, rcs_text(message.text, sizeof message.text)));
    }
    if (answer < GSIM_RCS_FAULT || answer > GSIM_RCS_MOTION_TIME_RAISED)
        return blame(fmt::format("answered {} with {}, which is no status", service.name, answer));
    if (answer > 0 && !(extra == Extra::step && may_answer_step(answer)) &&
        !(extra == Extra::raised && answer == GSIM_RCS_MOTION_TIME_RAISED)) {
        return blame(fmt::format("answered {} with {}, which is no answer to it", service.name,
                                 rrs::name(static_cast<Status>(answer))));
    }
    own_message_.reset();
    if (answer == GSIM_RCS_NOT_SUPPORTED)
        own_message_ = fmt::format("{} does not offer the service {}.", name(), service.name);
    return static_cast<Status>(answer);
}

Status RcsShell::ask_number(const Service& service, double value) {
    const gsim_rcs_number input{value};
    return ask(service, &input, nullptr);
}

Status RcsShell::ask_integer(const Service& service, int value) {
    const gsim_rcs_integer input{value};
    return ask(service, &input, nullptr);
}

Status RcsShell::put_joint_values(const Service& service, std::span<const int> joints,
                                  std::span<const double> values, gsim_rcs_joint_values& input) {
    constexpr std::size_t kMost = GSIM_RCS_MAX_JOINTS;
    if (joints.size() > kMost || values.size() > kMost)
        return refuse(fmt::format("{} takes at most {} values.", service.name, kMost));
    input.joint_count = static_cast<std::int32_t>(joints.size());
    input.value_count = static_cast<std::int32_t>(values.size());
    std::copy(joints.begin(), joints.end(), input.joints);
    std::copy(values.begin(), values.end(), input.values);
    return Status::RRS_SUCCESS;
}

Status RcsShell::ask_joint_values(const Service& service, std::span<const int> joints,
                                  std::span<const double> values) {
    gsim_rcs_joint_values input{};
    const Status status = put_joint_values(service, joints, values, input);
    return status == Status::RRS_SUCCESS ? ask(service, &input, nullptr) : status;
}

Status RcsShell::checked(const Service& service, const gsim_rcs_pose& answer, CartPos& pose) {
    const auto finite = [](double value) { return std::isfinite(value); };
    if (!std::all_of(std::begin(answer.matrix), std::end(answer.matrix), finite))
        return blame(fmt::format("answered {} with a pose that is not finite", service.name));
    pose = from_rcs(answer);
    return Status::RRS_SUCCESS;
}

Status RcsShell::checked(const Service& service, const gsim_rcs_joints& answer, double largest,
                         JointPos& joints) {
    if (answer.count != joint_count_) {
        return blame(fmt::format("answered {} with {} joint values; the machine has {} joints", service.name,
                                 answer.count, joint_count_));
    }
    for (int joint = 0; joint < joint_count_; ++joint) {
        const double value = answer.values[joint];
        if (!(std::abs(value) <= largest)) {
            return blame(
                fmt::format("answered {} with the value {} for joint {}", service.name, value, joint));
        }
    }
    joints = from_rcs(answer);
    return Status::RRS_SUCCESS;
}

Status RcsShell::checked_elapsed(const Service& service, double answer_s, double& elapsed_s) {
    if (!std::isfinite(answer_s))
        return blame(fmt::format("answered {} with a time of {} s", service.name, answer_s));
    if (answer_s < 0)
        return blame(
            fmt::format("answered {} with a time that runs backwards, by {} s", service.name, -answer_s));
    if (answer_s > interpolation_s_ * kStepRounding + clock_s_ * kClockRounding) {
        return blame(fmt::format("answered {} with a step of {} s; the interpolation time is {} s",
                                 service.name, answer_s, interpolation_s_));
    }
    elapsed_s = answer_s;
    return Status::RRS_SUCCESS;
}

/// Behind the services that set back all selections.
Status RcsShell::started(Status status) {
    if (is_refused(status)) return status;
    interpolation_s_ = kDefaultInterpolation_s;
    clock_s_ = 0;
    return status;
}

Status RcsShell::Initialize() {
    return started(ask({GSIM_RCS_INITIALIZE, "Initialize"}, nullptr, nullptr));
}

Status RcsShell::Reset() {
    return started(ask({GSIM_RCS_RESET, "Reset"}, nullptr, nullptr));
}

Status RcsShell::Terminate() {
    return started(ask({GSIM_RCS_TERMINATE, "Terminate"}, nullptr, nullptr));
}

Status RcsShell::GetMessage(std::string& message) {
    if (fault_ || own_message_) {
        message = fault_ ? *fault_ : *own_message_;
        return Status::RRS_SUCCESS;
    }
    gsim_rcs_message output{};
    const Status status = ask({GSIM_RCS_GET_MESSAGE, "GetMessage"}, nullptr, &output);
    if (status == Status::RRS_SUCCESS) message = rcs_text(output.text, sizeof output.text);
    return status;
}

Status RcsShell::GetInverseKinematics(const CartPos& pose, const JointPos& near, JointPos& joints) {
    const Service service{GSIM_RCS_GET_INVERSE_KINEMATICS, "GetInverseKinematics"};
    const gsim_rcs_pose_and_joints input{to_rcs(pose), to_rcs(near)};
    gsim_rcs_joints output = no_joints();
    const Status status = ask(service, &input, &output);
    return status == Status::RRS_SUCCESS ? checked(service, output, kLargest, joints) : status;
}

Status RcsShell::GetForwardKinematics(const JointPos& joints, CartPos& pose) {
    const Service service{GSIM_RCS_GET_FORWARD_KINEMATICS, "GetForwardKinematics"};
    const gsim_rcs_joints input = to_rcs(joints);
    gsim_rcs_pose output = no_pose();
    const Status status = ask(service, &input, &output);
    return status == Status::RRS_SUCCESS ? checked(service, output, pose) : status;
}

Status RcsShell::GetCellFrame(std::string_view frame_name, CartPos& frame) {
    const Service service{GSIM_RCS_GET_CELL_FRAME, "GetCellFrame"};
    gsim_rcs_frame input{};
    if (!put_text(frame_name, input.name)) return refuse("The name of the frame is too long.");
    gsim_rcs_pose output = no_pose();
    const Status status = ask(service, &input, &output);
    return status == Status::RRS_SUCCESS ? checked(service, output, frame) : status;
}

Status RcsShell::ModifyCellFrame(std::string_view frame_name, const CartPos& frame) {
    gsim_rcs_frame input{};
    if (!put_text(frame_name, input.name)) return refuse("The name of the frame is too long.");
    input.pose = to_rcs(frame);
    return ask({GSIM_RCS_MODIFY_CELL_FRAME, "ModifyCellFrame"}, &input, nullptr);
}

Status RcsShell::SelectWorkFrames(std::string_view tool_frame, std::string_view object_frame) {
    gsim_rcs_work_frames input{};
    if (!put_text(tool_frame, input.tool) || !put_text(object_frame, input.object))
        return refuse("The name of the frame is too long.");
    return ask({GSIM_RCS_SELECT_WORK_FRAMES, "SelectWorkFrames"}, &input, nullptr);
}

Status RcsShell::SelectTargetType(TargetType type) {
    return ask_integer({GSIM_RCS_SELECT_TARGET_TYPE, "SelectTargetType"}, static_cast<int>(type));
}

Status RcsShell::SelectTrajectoryMode(int mode) {
    return ask_integer({GSIM_RCS_SELECT_TRAJECTORY_MODE, "SelectTrajectoryMode"}, mode);
}

Status RcsShell::SetInitialPosition(const CartPos& cartesian, const JointPos& joints,
                                    std::string_view configuration) {
    gsim_rcs_position input{to_rcs(cartesian), to_rcs(joints), {}};
    if (!put_text(configuration, input.configuration)) return refuse("The configuration is too long.");
    return ask({GSIM_RCS_SET_INITIAL_POSITION, "SetInitialPosition"}, &input, nullptr);
}

Status RcsShell::ask_target(const Service& service, gsim_rcs_target& target, std::string_view configuration,
                            std::string_view name) {
    if (!put_text(configuration, target.position.configuration))
        return refuse("The configuration is too long.");
    if (!put_text(name, target.name)) return refuse("The name of the target is too long.");
    return ask(service, &target, nullptr, Extra::raised);
}

Status RcsShell::SetNextTarget(TargetId id, TargetParam param, const CartPos& cartesian,
                               const JointPos& joints, std::string_view configuration, double param_value) {
    gsim_rcs_target input{
        id, static_cast<int>(param), 0, {to_rcs(cartesian), to_rcs(joints), {}}, param_value, {}};
    return ask_target({GSIM_RCS_SET_NEXT_TARGET, "SetNextTarget"}, input, configuration, {});
}

Status RcsShell::SetNextNamedTarget(TargetId id, TargetParam param, const CartPos& cartesian,
                                    const JointPos& joints, std::string_view configuration,
                                    double param_value, std::string_view target_name) {
    gsim_rcs_target input{
        id, static_cast<int>(param), 0, {to_rcs(cartesian), to_rcs(joints), {}}, param_value, {}};
    return ask_target({GSIM_RCS_SET_NEXT_NAMED_TARGET, "SetNextNamedTarget"}, input, configuration,
                      target_name);
}

Status RcsShell::GetNextStep(JointPos& joints, CartPos& pose, double& elapsed_s) {
    const Service service{GSIM_RCS_GET_NEXT_STEP, "GetNextStep"};
    gsim_rcs_step output{no_joints(), no_pose(), kNan};
    const Status status = ask(service, nullptr, &output, Extra::step);
    if (is_refused(status)) return status;
    for (const Status check :
         {checked_elapsed(service, output.elapsed_s, elapsed_s),
          checked(service, output.joints, kLargestOfStep, joints), checked(service, output.pose, pose)}) {
        if (check != Status::RRS_SUCCESS) return check;
    }
    clock_s_ += elapsed_s;
    return status;
}

Status RcsShell::SetInterpolationTime(double interpolation_s) {
    const Status status =
        ask_number({GSIM_RCS_SET_INTERPOLATION_TIME, "SetInterpolationTime"}, interpolation_s);
    if (status == Status::RRS_SUCCESS) interpolation_s_ = interpolation_s;
    return status;
}

Status RcsShell::StopMotion() {
    return ask({GSIM_RCS_STOP_MOTION, "StopMotion"}, nullptr, nullptr);
}

Status RcsShell::ContinueMotion() {
    return ask({GSIM_RCS_CONTINUE_MOTION, "ContinueMotion"}, nullptr, nullptr);
}

Status RcsShell::CancelMotion() {
    return ask({GSIM_RCS_CANCEL_MOTION, "CancelMotion"}, nullptr, nullptr);
}

Status RcsShell::SetNextArcTarget(TargetId id, const Eigen::Vector3d& center_mm, const Eigen::Vector3d& axis,
                                  double sweep_rad, const CartPos& cartesian, const JointPos& joints) {
    const gsim_rcs_arc_target input{id,
                                    {center_mm.x(), center_mm.y(), center_mm.z()},
                                    {axis.x(), axis.y(), axis.z()},
                                    sweep_rad,
                                    {to_rcs(cartesian), to_rcs(joints)}};
    return ask({GSIM_RCS_SET_NEXT_ARC_TARGET, "SetNextArcTarget"}, &input, nullptr, Extra::raised);
}

Status RcsShell::SetNextRest(TargetId id, double rest_s) {
    const gsim_rcs_rest input{id, rest_s};
    return ask({GSIM_RCS_SET_NEXT_REST, "SetNextRest"}, &input, nullptr);
}

Status RcsShell::GetTargetOfLastStep(TargetId& id) {
    gsim_rcs_target_id output{-1};
    const Status status = ask({GSIM_RCS_GET_TARGET_OF_LAST_STEP, "GetTargetOfLastStep"}, nullptr, &output);
    if (status == Status::RRS_SUCCESS) id = output.id;
    return status;
}

Status RcsShell::ComeToRest(RestReason reason) {
    return ask_integer({GSIM_RCS_COME_TO_REST, "ComeToRest"}, static_cast<int>(reason));
}

}  // namespace gsim::rrs
