#include "engine/src/values.h"

#include <fmt/format.h>

#include "engine/run.h"

namespace gsim::engine {

Diagnostic diagnostic_of(const text::Diagnostic& told) {
    return {.severity = static_cast<Severity>(told.severity),
            .code = std::string(text::code_of(told.kind)),
            .file = told.file,
            .line = told.line,
            .column = told.column,
            .end_column = told.end_column,
            .text = told.text,
            .hint = told.hint,
            .excerpt = told.excerpt};
}

text::Diagnostic inner_diagnostic(const Diagnostic& told) {
    return {.severity = static_cast<text::Severity>(told.severity),
            .kind = text::diagnostic_kind(told.code).value_or(text::DiagnosticKind::warning),
            .file = told.file,
            .line = told.line,
            .column = told.column,
            .end_column = told.end_column,
            .text = told.text,
            .hint = told.hint,
            .excerpt = told.excerpt};
}

Failure failure_of(text::DiagnosticKind kind, std::string message, std::string file) {
    return {.code = std::string(text::code_of(kind)), .message = std::move(message), .file = std::move(file)};
}

Failure failure_of(const InputError& error) {
    Failure failure = failure_of(error.kind, error.message, error.file);
    failure.in_program = error.in_program;
    if (error.first_error) failure.first_error = diagnostic_of(*error.first_error);
    return failure;
}

AxisValues axis_values(const machine::Machine& machine, const rrs::JointPos& joints) {
    AxisValues values{};
    for (std::size_t i = 0; i < machine.axes.size(); ++i)
        values[i] = machine::axis_value(machine.axes[i], joints[static_cast<Eigen::Index>(i)]);
    return values;
}

std::optional<std::string> fault_of_step(double step_s) {
    constexpr double kLeast_s = kLeastStep_s;
    if (step_s >= kLeast_s) return std::nullopt;
    return fmt::format("the step of a trajectory is {} s; {} s is the least", step_s, kLeast_s);
}

}  // namespace gsim::engine
