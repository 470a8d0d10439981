#pragma once

#include <span>
#include <string>

#include "engine/api.h"
#include "engine/diagnostic.h"

namespace gsim::engine {

/// A program that was run to find its errors.
struct CheckedProgram {
    std::string name;
    std::string status;       ///< As in a report; "not run" if its text has errors or cannot be read.
    double cycle_time_s = 0;  ///< Up to the end, or to what ended it.
};

/// Returns "part.nc:12:7: error: text; hint" and the excerpt, in full lines.
GSIM_API std::string diagnostic_text(const Diagnostic& diagnostic);

/// Returns a failure as a diagnostic, with the source location that its message begins with.
GSIM_API Diagnostic to_diagnostic(const Error& error);

/// Returns {"diagnostics": [...]}: each with file, line, column, end_column, severity, code, text and hint
/// (null if not known), preceded by {"programs": [...]} if programs are given (docs/diagnostics.md).
GSIM_API std::string findings_json(std::span<const Diagnostic> diagnostics,
                                   std::span<const CheckedProgram> programs = {});

/// Returns the same as SARIF 2.1.0 (OASIS), which code hosts show next to the lines; rules are the kinds that
/// occur.
GSIM_API std::string findings_sarif(std::span<const Diagnostic> diagnostics);

}  // namespace gsim::engine
