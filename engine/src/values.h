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
Diagnostic diagnostic_of(const text::Diagnostic& told);
/// Returns the inverse conversion.
text::Diagnostic inner_diagnostic(const Diagnostic& told);
Failure failure_of(text::DiagnosticKind kind, std::string message, std::string file = {});
Failure failure_of(const InputError& error);
AxisValues axis_values(const machine::Machine& machine, const rrs::JointPos& joints);

/// Returns a message if a trajectory cannot have this step; nothing if it can.
std::optional<std::string> fault_of_step(double step_s);

Report report_of(simulation::Report report);
Report report_of(simulation::RobotsReport report);

}  // namespace gsim::engine
