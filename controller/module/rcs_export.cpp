#include "controller/module/rcs_export.h"

#include <exception>
#include <utility>

#include "controller/module/rcs_codec.h"
#include "controller/services/service_call.h"

struct gsim_rcs_module {
    std::unique_ptr<gsim::rrs::Shell> shell;
    std::string exception_text;  // message of an exception until it is reported
};

namespace gsim::rrs {

namespace {

template <typename Input, typename Output, typename Method>
Status serve(Shell& shell, Method method, const void* in, void* out) {
    const Input none{};
    const auto inputs = get_values<ServiceTraits<Method>::kInputs>(
        std::is_same_v<Input, gsim_rcs_none> ? none : *static_cast<const Input*>(in));
    if (!inputs) return Status::RRS_INVALID_PARAMETER;
    typename ServiceTraits<Method>::Outputs outputs{};
    const Status status = call(shell, method, *inputs, outputs);
    if constexpr (!std::is_same_v<Output, gsim_rcs_none>) {
        // A message that is too long is truncated.
        if (!is_error_status(status))
            std::apply([out](const auto&... values) { write(*static_cast<Output*>(out), values...); },
                       outputs);
    }
    return status;
}

Status dispatch(Shell& shell, std::int32_t service_number, const void* in, void* out) {
    switch (service_number) {
#define GSIM_RCS_SERVICE(method, opcode, number, rrs, input, statuses, parameters, arguments) \
    case GSIM_RCS_##opcode:                                                                   \
        return serve<gsim_rcs_##input, gsim_rcs_none>(shell, &Shell::method, in, out);
#define GSIM_RCS_QUERY(method, opcode, number, rrs, input, output, statuses, parameters, arguments) \
    case GSIM_RCS_##opcode:                                                                         \
        return serve<gsim_rcs_##input, gsim_rcs_##output>(shell, &Shell::method, in, out);
#include "controller/module/rcs_services.def"
        default: return Status::RRS_SERVICE_NOT_SUPPORTED;
    }
}

/// Returns the text of the exception that is being handled.
std::string current_exception_text() {
    try {
        throw;
    } catch (const std::exception& error) {
        return error.what();
    } catch (...) {
        return "an exception that is not a std::exception";
    }
}

}  // namespace

gsim_rcs_module* create_exported(ShellFactory make, const gsim_rcs_machine* machine,
                                 gsim_rcs_message* message) noexcept {
    try {
        auto shell = make(*machine);
        if (shell) return new gsim_rcs_module{std::move(*shell), {}};
        copy_text(shell.error().message, message->text);
    } catch (...) {
        copy_text(current_exception_text(), message->text);
    }
    return nullptr;
}

void destroy_exported(gsim_rcs_module* module) noexcept {
    delete module;
}

std::int32_t call_exported(gsim_rcs_module* module, std::int32_t opcode, const void* input,
                           void* output) noexcept {
    try {
        if (opcode == GSIM_RCS_GET_MESSAGE && !module->exception_text.empty()) {
            copy_text(std::exchange(module->exception_text, {}),
                      static_cast<gsim_rcs_message*>(output)->text);
            return GSIM_RCS_SUCCESS;
        }
        return static_cast<std::int32_t>(dispatch(*module->shell, opcode, input, output));
    } catch (...) {
        module->exception_text = current_exception_text();
        return GSIM_RCS_FAULT;
    }
}

}  // namespace gsim::rrs
