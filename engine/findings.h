#pragma once

#include <span>
#include <string>

#include "engine/api.h"
#include "engine/diagnostic.h"

namespace gsim::engine {

/// A program that was run to see what is wrong with it.
struct CheckedProgram {
    std::string name;
    std::string status;       ///< As in a report; "not run" where its text has errors or cannot be read.
    double cycle_time_s = 0;  ///< Up to the end, or to what ended it.
};

/// "part.nc:12:7: error: text; hint" and the excerpt, in whole lines.
GSIM_API std::string text_of(const Diagnostic& told);

/// A failure as one thing to tell, with the place that its sentence begins with.
GSIM_API Diagnostic diagnostic_of(const Failure& failure);

/// {"diagnostics": [...]}: each with file, line, column, end_column, severity, code, text and hint (null
/// where not known), behind {"programs": [...]} where there are any (docs/diagnostics.md).
GSIM_API std::string findings_json(std::span<const Diagnostic> diagnostics,
                                   std::span<const CheckedProgram> programs = {});

/// The same as SARIF 2.1.0 (OASIS), which code hosts show beside the lines; rules are the kinds that occur.
GSIM_API std::string findings_sarif(std::span<const Diagnostic> diagnostics);

}  // namespace gsim::engine
