#include "engine/src/conversions.h"

#include <fmt/format.h>

#include "engine/run.h"

namespace gsim::engine {

Diagnostic to_diagnostic(const text::Diagnostic& diagnostic) {
    return {.severity = static_cast<Severity>(diagnostic.severity),
            .code = std::string(text::diagnostic_code(diagnostic.kind)),
            .file = diagnostic.file,
            .line = diagnostic.line,
            .column = diagnostic.column,
            .end_column = diagnostic.end_column,
            .text = diagnostic.text,
            .hint = diagnostic.hint,
            .excerpt = diagnostic.excerpt};
}

text::Diagnostic to_text_diagnostic(const Diagnostic& diagnostic) {
    return {.severity = static_cast<text::Severity>(diagnostic.severity),
            .kind = text::diagnostic_kind(diagnostic.code).value_or(text::DiagnosticKind::warning),
            .file = diagnostic.file,
            .line = diagnostic.line,
            .column = diagnostic.column,
            .end_column = diagnostic.end_column,
            .text = diagnostic.text,
            .hint = diagnostic.hint,
            .excerpt = diagnostic.excerpt};
}

Error make_error(text::DiagnosticKind kind, gsim::Error error, std::string file) {
    return {.code = std::string(text::diagnostic_code(kind)),
            .message = std::move(error.message),
            .file = std::move(file)};
}

AxisValues axis_values(const machine::Machine& machine, const rrs::JointPos& joints) {
    AxisValues values{};
    for (std::size_t i = 0; i < machine.axes.size(); ++i)
        values[i] = machine::axis_value(machine.axes[i], joints[static_cast<Eigen::Index>(i)]);
    return values;
}

std::optional<gsim::Error> find_step_error(double step_s) {
    constexpr double kMin_s = kMinStep_s;
    if (step_s >= kMin_s) return std::nullopt;
    return fmt::format("the step of a trajectory is {} s; it must be at least {} s", step_s, kMin_s);
}

}  // namespace gsim::engine
