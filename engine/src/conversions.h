#pragma once

#include <optional>
#include <string>

#include "base/text/diagnostic.h"
#include "engine/diagnostic.h"
#include "engine/motion.h"
#include "engine/report.h"
#include "engine/src/run/script_input.h"
#include "machine/model/machine.h"
#include "runtime/report/robots_report.h"

namespace gsim::engine {

/// Returns a diagnostic of this library in the form for its users.
Diagnostic to_diagnostic(const text::Diagnostic& diagnostic);
/// Returns the inverse conversion.
text::Diagnostic to_text_diagnostic(const Diagnostic& diagnostic);
Error make_error(text::DiagnosticKind kind, std::string message, std::string file = {});
Error make_error(const InputError& error);
AxisValues axis_values(const machine::Machine& machine, const rrs::JointPos& joints);

/// Returns a message if a trajectory cannot have this step; nothing if it can.
std::optional<std::string> check_step(double step_s);

Report make_report(simulation::Report report);
Report make_report(simulation::RobotsReport report);

}  // namespace gsim::engine
