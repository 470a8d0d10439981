// The services that a controller module is asked for, and the checks of what it answers.

#include "runtime/rrs/rcs_shell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "runtime/rrs/rcs_codec.h"

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

}  // namespace

Status RcsShell::blame(std::string_view what) {
    if (!fault_) fault_ = fmt::format("The controller module {} {}.", name(), what);
    return Status::RRS_MODULE_FAULT;
}

Status RcsShell::refuse(std::string message) {
    own_message_ = std::move(message);
    return Status::RRS_INVALID_PARAMETER;
}

Status RcsShell::ask(const Service& service, const void* input, void* output) {
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
    const auto status = static_cast<Status>(answer);
    if (answer > 0 && !service.answers.holds(status)) {
        return blame(
            fmt::format("answered {} with {}, which is no answer to it", service.name, rrs::name(status)));
    }
    own_message_.reset();
    if (answer == GSIM_RCS_NOT_SUPPORTED)
        own_message_ = fmt::format("{} does not offer the service {}.", name(), service.name);
    return status;
}

/// Asks for a service with values that become its input.
template <typename Input, typename... Arguments>
Status RcsShell::tell(const Service& service, const std::tuple<Arguments...>& arguments, void* output) {
    Input input{};
    if (const auto misfit =
            std::apply([&](const auto&... values) { return put(input, values...); }, arguments)) {
        const std::string_view subject = misfit->subject.empty() ? service.name : misfit->subject;
        return refuse(fmt::format("{} {}.", subject, misfit->fault));
    }
    const Status status = ask(service, std::is_same_v<Input, gsim_rcs_none> ? nullptr : &input, output);
    if (!is_refused(status)) heard(service, input);
    return status;
}

/// What of a service's success is known here, too.
template <typename Input>
void RcsShell::heard(const Service& service, const Input& input) {
    if constexpr (std::is_same_v<Input, gsim_rcs_number>) {
        if (service.opcode == GSIM_RCS_SET_INTERPOLATION_TIME) interpolation_s_ = input.value;
    } else if (service.opcode == GSIM_RCS_INITIALIZE || service.opcode == GSIM_RCS_RESET) {
        interpolation_s_ = kDefaultInterpolation_s;
        clock_s_ = 0;
    }
}

// Services that give nothing but a status; the others follow.
#define GSIM_RCS_QUERY(method, opcode, number, rrs, input, output, answers, parameters, arguments)
#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, answers, parameters, arguments) \
    Status RcsShell::method parameters {                                                     \
        return tell<gsim_rcs_##input>(services::method, std::tie arguments);                 \
    }
#include "runtime/rrs/rcs_services.def"

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

Status RcsShell::GetMessage(std::string& message) {
    if (fault_ || own_message_) {
        message = fault_ ? *fault_ : *own_message_;
        return Status::RRS_SUCCESS;
    }
    gsim_rcs_message output{};
    const Status status = ask(services::GetMessage, nullptr, &output);
    if (status == Status::RRS_SUCCESS) message = rcs_text(output.text, sizeof output.text);
    return status;
}

Status RcsShell::GetInverseKinematics(const CartPos& pose, const JointPos& near, JointPos& joints) {
    const Service& service = services::GetInverseKinematics;
    gsim_rcs_joints output = no_joints();
    const Status status = tell<gsim_rcs_pose_and_joints>(service, std::tie(pose, near), &output);
    return status == Status::RRS_SUCCESS ? checked(service, output, kLargest, joints) : status;
}

Status RcsShell::GetForwardKinematics(const JointPos& joints, CartPos& pose) {
    const Service& service = services::GetForwardKinematics;
    gsim_rcs_pose output = no_pose();
    const Status status = tell<gsim_rcs_joints>(service, std::tie(joints), &output);
    return status == Status::RRS_SUCCESS ? checked(service, output, pose) : status;
}

Status RcsShell::GetCellFrame(std::string_view frame_name, CartPos& frame) {
    const Service& service = services::GetCellFrame;
    gsim_rcs_pose output = no_pose();
    const Status status = tell<gsim_rcs_frame>(service, std::tie(frame_name), &output);
    return status == Status::RRS_SUCCESS ? checked(service, output, frame) : status;
}

Status RcsShell::GetNextStep(JointPos& joints, CartPos& pose, double& elapsed_s) {
    const Service& service = services::GetNextStep;
    gsim_rcs_step output{no_joints(), no_pose(), kNan};
    const Status status = ask(service, nullptr, &output);
    if (is_refused(status)) return status;
    for (const Status check :
         {checked_elapsed(service, output.elapsed_s, elapsed_s),
          checked(service, output.joints, kLargestOfStep, joints), checked(service, output.pose, pose)}) {
        if (check != Status::RRS_SUCCESS) return check;
    }
    clock_s_ += elapsed_s;
    return status;
}

Status RcsShell::GetNextObjectStep(CartPos& pose, double& elapsed_s) {
    const Service& service = services::GetNextObjectStep;
    gsim_rcs_object_step output{no_pose(), kNan};
    const Status status = ask(service, nullptr, &output);
    if (is_refused(status)) return status;
    for (const Status check :
         {checked_elapsed(service, output.elapsed_s, elapsed_s), checked(service, output.pose, pose)}) {
        if (check != Status::RRS_SUCCESS) return check;
    }
    return status;
}

Status RcsShell::GetEvent(int number, int& event_id, double& time_s) {
    const Service& service = services::GetEvent;
    gsim_rcs_event output{0, 0, kNan};
    const Status status = tell<gsim_rcs_integer>(service, std::tie(number), &output);
    if (status != Status::RRS_SUCCESS) return status;
    if (!(output.time_s <= interpolation_s_ && std::isfinite(output.time_s))) {
        return blame(fmt::format("answered {} with the time {} s; the interpolation time is {} s",
                                 service.name, output.time_s, interpolation_s_));
    }
    event_id = output.event;
    time_s = output.time_s;
    return status;
}

Status RcsShell::GetTargetOfLastStep(TargetId& id) {
    gsim_rcs_target_id output{-1};
    const Status status = ask(services::GetTargetOfLastStep, nullptr, &output);
    if (status == Status::RRS_SUCCESS) id = output.id;
    return status;
}

}  // namespace gsim::rrs
