// Requests of services to a controller module, and the checks of its results.

#include "controller/module/rcs_shell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "controller/module/rcs_codec.h"
#include "controller/module/rcs_unset_output.h"
#include "controller/services/service_call.h"

namespace gsim::rrs {

namespace {

constexpr double kMaxFiniteValue = std::numeric_limits<double>::max();
constexpr double kMaxStepValue = 1e15;  // mm or rad: beyond any target; sums over a run stay finite
constexpr double kStepRounding = 1 + 1e-6;
constexpr double kClockRounding = 1e-12;  // a step is a difference of two instants

/// Returns some of the elements of a tuple of references, from `first` on.
template <std::size_t first, typename... Elements, std::size_t... at>
auto tuple_part(const std::tuple<Elements...>& all, std::index_sequence<at...> /*count*/) {
    return std::tie(std::get<first + at>(all)...);
}

}  // namespace

Status RcsShell::report_module_error(std::string_view what) {
    if (!error_) error_ = fmt::format("The controller module {} {}.", name(), what);
    return Status::RRS_MODULE_FAULT;
}

Status RcsShell::reject(std::string message) {
    host_message_ = std::move(message);
    return Status::RRS_INVALID_PARAMETER;
}

Status RcsShell::send_request(const Service& service, const void* input, void* output) {
    if (error_) return Status::RRS_MODULE_FAULT;
    before_call();
    const int result = module_.call(service.opcode, input, output);
    if (result == GSIM_RCS_SUCCESS) return Status::RRS_SUCCESS;
    if (result == GSIM_RCS_FAULT) {
        if (const auto loss = module_.loss()) return report_module_error(*loss);
        gsim_rcs_message message{};
        module_.call(GSIM_RCS_GET_MESSAGE, nullptr, &message);
        return report_module_error(
            fmt::format("failed in {}: {}", service.name, rcs_text(message.text, sizeof message.text)));
    }
    if (result < GSIM_RCS_FAULT || result > GSIM_RCS_MOTION_TIME_RAISED)
        return report_module_error(
            fmt::format("responded to {} with {}, which is not a status", service.name, result));
    const auto status = static_cast<Status>(result);
    if (result > 0 && !service.statuses.contains(status)) {
        return report_module_error(fmt::format("responded to {} with {}, which is not a valid response",
                                               service.name, rrs::name(status)));
    }
    host_message_.reset();
    if (result == GSIM_RCS_NOT_SUPPORTED)
        host_message_ = fmt::format("{} does not support the service {}.", name(), service.name);
    return status;
}

/// Requests a service with values that become its input.
template <typename Input, typename... Arguments>
Status RcsShell::request_service(const Service& service, const std::tuple<Arguments...>& arguments,
                                 void* output) {
    Input input{};
    if (const auto field_error =
            std::apply([&](const auto&... values) { return write(input, values...); }, arguments)) {
        const std::string_view subject = field_error->subject.empty() ? service.name : field_error->subject;
        return reject(fmt::format("{} {}.", subject, field_error->error));
    }
    const Status status =
        send_request(service, std::is_same_v<Input, gsim_rcs_none> ? nullptr : &input, output);
    if (!is_error_status(status)) apply_effects(service, input);
    return status;
}

/// Stores effects of a successful service that matter here, too.
template <typename Input>
void RcsShell::apply_effects(const Service& service, const Input& input) {
    if constexpr (std::is_same_v<Input, gsim_rcs_number>) {
        if (service.opcode == GSIM_RCS_SET_INTERPOLATION_TIME) interpolation_s_ = input.value;
    } else if (service.opcode == GSIM_RCS_INITIALIZE || service.opcode == GSIM_RCS_RESET) {
        interpolation_s_ = kDefaultInterpolation_s;
        clock_s_ = 0;
    }
}

bool RcsShell::is_valid_step(double result_s) const {
    return result_s >= 0 && result_s <= interpolation_s_ * kStepRounding + clock_s_ * kClockRounding;
}

Status RcsShell::report_step_error(const Service& service, double result_s) {
    if (!std::isfinite(result_s))
        return report_module_error(
            fmt::format("responded to {} with a time of {} s", service.name, result_s));
    if (result_s < 0)
        return report_module_error(
            fmt::format("responded to {} with a time that decreases by {} s", service.name, -result_s));
    return report_module_error(
        fmt::format("responded to {} with a step of {} s; the interpolation time is {} s", service.name,
                    result_s, interpolation_s_));
}

Status RcsShell::check_joint_values(const Service& service, const gsim_rcs_joints& result,
                                    double max_abs_value) {
    if (result.count != joint_count_) {
        return report_module_error(
            fmt::format("responded to {} with {} joint values; the machine has {} joints", service.name,
                        result.count, joint_count_));
    }
    for (int joint = 0; joint < joint_count_; ++joint) {
        const double value = result.values[joint];
        if (!(std::abs(value) <= max_abs_value)) {
            return report_module_error(
                fmt::format("responded to {} with the value {} for joint {}", service.name, value, joint));
        }
    }
    return Status::RRS_SUCCESS;
}

// One check for each output structure of services.

Status RcsShell::check_response(const Service& /*service*/, const gsim_rcs_message& /*answer*/) {
    return Status::RRS_SUCCESS;
}

Status RcsShell::check_response(const Service& /*service*/, const gsim_rcs_target_id& /*answer*/) {
    return Status::RRS_SUCCESS;
}

Status RcsShell::check_response(const Service& service, const gsim_rcs_pose& result) {
    const auto is_finite = [](double value) { return std::isfinite(value); };
    if (std::all_of(std::begin(result.matrix), std::end(result.matrix), is_finite))
        return Status::RRS_SUCCESS;
    return report_module_error(fmt::format("responded to {} with a pose that is not finite", service.name));
}

Status RcsShell::check_response(const Service& service, const gsim_rcs_joints& result) {
    return check_joint_values(service, result, kMaxFiniteValue);
}

Status RcsShell::check_response(const Service& service, const gsim_rcs_step& result) {
    if (!is_valid_step(result.elapsed_s)) return report_step_error(service, result.elapsed_s);
    const Status joints = check_joint_values(service, result.joints, kMaxStepValue);
    if (joints != Status::RRS_SUCCESS) return joints;
    const Status pose = check_response(service, result.pose);
    if (pose == Status::RRS_SUCCESS) clock_s_ += result.elapsed_s;
    return pose;
}

Status RcsShell::check_response(const Service& service, const gsim_rcs_object_step& result) {
    if (!is_valid_step(result.elapsed_s)) return report_step_error(service, result.elapsed_s);
    return check_response(service, result.pose);
}

Status RcsShell::check_response(const Service& service, const gsim_rcs_event& result) {
    if (result.time_s <= interpolation_s_ && std::isfinite(result.time_s)) return Status::RRS_SUCCESS;
    return report_module_error(
        fmt::format("responded to {} with the time {} s; the interpolation time is {} s", service.name,
                    result.time_s, interpolation_s_));
}

/// Requests a service that returns more than a status: `arguments` are its inputs, then its outputs.
template <typename Input, typename Output, typename Method, typename... Arguments>
Status RcsShell::query(const Service& service, Method /*method*/, const std::tuple<Arguments...>& arguments) {
    constexpr std::size_t kInputs = ServiceTraits<Method>::kInputs;
    constexpr std::size_t kOutputs = sizeof...(Arguments) - kInputs;
    auto outputs = tuple_part<kInputs>(arguments, std::make_index_sequence<kOutputs>());
    if constexpr (std::is_same_v<Output, gsim_rcs_message>) {  // what is known here needs no module
        if (error_ || host_message_) {
            std::get<0>(outputs) = error_ ? *error_ : *host_message_;
            return Status::RRS_SUCCESS;
        }
    }
    Output result = make_unset_output<Output>();
    const Status status = request_service<Input>(
        service, tuple_part<0>(arguments, std::make_index_sequence<kInputs>()), &result);
    if (is_error_status(status)) return status;
    const Status check = check_response(service, result);
    if (check != Status::RRS_SUCCESS) return check;
    outputs = *get_values<kOutputs>(std::as_const(result));
    return status;
}

#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, statuses, parameters, arguments) \
    Status RcsShell::method parameters {                                                      \
        return request_service<gsim_rcs_##input>(services::method, std::tie arguments);       \
    }
#define GSIM_RCS_QUERY(method, opcode, number, rrs, input, output, statuses, parameters, arguments) \
    Status RcsShell::method parameters {                                                            \
        return query<gsim_rcs_##input, gsim_rcs_##output>(services::method, &Shell::method,         \
                                                          std::tie arguments);                      \
    }
#include "controller/module/rcs_services.def"

}  // namespace gsim::rrs
