// Requests of services to a controller module, and the checks of its results.

#include "controller/module/rcs_shell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "controller/module/rcs_codec.h"
#include "controller/module/rcs_unanswered.h"
#include "controller/services/service_call.h"

namespace gsim::rrs {

namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kLargestOfStep = 1e15;  // mm or rad: beyond any target; sums over a run stay finite
constexpr double kStepRounding = 1 + 1e-6;
constexpr double kClockRounding = 1e-12;  // a step is a difference of two instants

/// Returns some of the elements of a tuple of references, from `first` on.
template <std::size_t first, typename... Elements, std::size_t... at>
auto part_of(const std::tuple<Elements...>& all, std::index_sequence<at...> /*count*/) {
    return std::tie(std::get<first + at>(all)...);
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
        if (const auto loss = module_.loss()) return blame(*loss);
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

/// Requests a service with values that become its input.
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

/// Stores effects of a successful service that matter here, too.
template <typename Input>
void RcsShell::heard(const Service& service, const Input& input) {
    if constexpr (std::is_same_v<Input, gsim_rcs_number>) {
        if (service.opcode == GSIM_RCS_SET_INTERPOLATION_TIME) interpolation_s_ = input.value;
    } else if (service.opcode == GSIM_RCS_INITIALIZE || service.opcode == GSIM_RCS_RESET) {
        interpolation_s_ = kDefaultInterpolation_s;
        clock_s_ = 0;
    }
}

bool RcsShell::is_step(double answer_s) const {
    return answer_s >= 0 && answer_s <= interpolation_s_ * kStepRounding + clock_s_ * kClockRounding;
}

Status RcsShell::blame_step(const Service& service, double answer_s) {
    if (!std::isfinite(answer_s))
        return blame(fmt::format("answered {} with a time of {} s", service.name, answer_s));
    if (answer_s < 0)
        return blame(
            fmt::format("answered {} with a time that runs backwards, by {} s", service.name, -answer_s));
    return blame(fmt::format("answered {} with a step of {} s; the interpolation time is {} s", service.name,
                             answer_s, interpolation_s_));
}

Status RcsShell::checked_joints(const Service& service, const gsim_rcs_joints& answer, double largest) {
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
    return Status::RRS_SUCCESS;
}

// One check for each output structure of services.

Status RcsShell::checked(const Service& /*service*/, const gsim_rcs_message& /*answer*/) {
    return Status::RRS_SUCCESS;
}

Status RcsShell::checked(const Service& /*service*/, const gsim_rcs_target_id& /*answer*/) {
    return Status::RRS_SUCCESS;
}

Status RcsShell::checked(const Service& service, const gsim_rcs_pose& answer) {
    const auto finite = [](double value) { return std::isfinite(value); };
    if (std::all_of(std::begin(answer.matrix), std::end(answer.matrix), finite)) return Status::RRS_SUCCESS;
    return blame(fmt::format("answered {} with a pose that is not finite", service.name));
}

Status RcsShell::checked(const Service& service, const gsim_rcs_joints& answer) {
    return checked_joints(service, answer, kLargest);
}

Status RcsShell::checked(const Service& service, const gsim_rcs_step& answer) {
    if (!is_step(answer.elapsed_s)) return blame_step(service, answer.elapsed_s);
    const Status joints = checked_joints(service, answer.joints, kLargestOfStep);
    if (joints != Status::RRS_SUCCESS) return joints;
    const Status pose = checked(service, answer.pose);
    if (pose == Status::RRS_SUCCESS) clock_s_ += answer.elapsed_s;
    return pose;
}

Status RcsShell::checked(const Service& service, const gsim_rcs_object_step& answer) {
    if (!is_step(answer.elapsed_s)) return blame_step(service, answer.elapsed_s);
    return checked(service, answer.pose);
}

Status RcsShell::checked(const Service& service, const gsim_rcs_event& answer) {
    if (answer.time_s <= interpolation_s_ && std::isfinite(answer.time_s)) return Status::RRS_SUCCESS;
    return blame(fmt::format("answered {} with the time {} s; the interpolation time is {} s", service.name,
                             answer.time_s, interpolation_s_));
}

/// Requests a service that returns more than a status: `arguments` are its inputs, then its outputs.
template <typename Input, typename Output, typename Method, typename... Arguments>
Status RcsShell::query(const Service& service, Method /*method*/, const std::tuple<Arguments...>& arguments) {
    constexpr std::size_t kInputs = ServiceTraits<Method>::kInputs;
    constexpr std::size_t kOutputs = sizeof...(Arguments) - kInputs;
    auto outputs = part_of<kInputs>(arguments, std::make_index_sequence<kOutputs>());
    if constexpr (std::is_same_v<Output, gsim_rcs_message>) {  // what is known here needs no module
        if (fault_ || own_message_) {
            std::get<0>(outputs) = fault_ ? *fault_ : *own_message_;
            return Status::RRS_SUCCESS;
        }
    }
    Output answer = unanswered<Output>();
    const Status status =
        tell<Input>(service, part_of<0>(arguments, std::make_index_sequence<kInputs>()), &answer);
    if (is_refused(status)) return status;
    const Status check = checked(service, answer);
    if (check != Status::RRS_SUCCESS) return check;
    outputs = *take<kOutputs>(std::as_const(answer));
    return status;
}

#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, answers, parameters, arguments) \
    Status RcsShell::method parameters {                                                     \
        return tell<gsim_rcs_##input>(services::method, std::tie arguments);                 \
    }
#define GSIM_RCS_QUERY(method, opcode, number, rrs, input, output, answers, parameters, arguments) \
    Status RcsShell::method parameters {                                                           \
        return query<gsim_rcs_##input, gsim_rcs_##output>(services::method, &Shell::method,        \
                                                          std::tie arguments);                     \
    }
#include "controller/module/rcs_services.def"

}  // namespace gsim::rrs
