#pragma once

#include <optional>
#include <string>

#include "base/error.h"
#include "base/text/diagnostic.h"
#include "engine/diagnostic.h"
#include "engine/motion.h"
#include "engine/report.h"
#include "machine/model/machine.h"
#include "runtime/report/robots_report.h"

namespace gsim::engine {

/// Returns a diagnostic of this library in the form for its users.
Diagnostic to_diagnostic(const text::Diagnostic& diagnostic);
/// Returns the inverse conversion.
text::Diagnostic to_text_diagnostic(const Diagnostic& diagnostic);
/// Returns an error in the form for users; `file` is the input that its message does not name.
Error make_error(text::DiagnosticKind kind, gsim::Error error, std::string file = {});
AxisValues axis_values(const machine::Machine& machine, const rrs::JointPos& joints);

/// Returns an error if a trajectory cannot have this step.
std::optional<gsim::Error> find_step_error(double step_s);

Report make_report(simulation::Report report);
Report make_report(simulation::RobotsReport report);

}  // namespace gsim::engine
