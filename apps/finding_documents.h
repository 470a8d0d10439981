#pragma once

#include <span>
#include <string>

#include "base/text/diagnostic.h"

namespace gsim::apps {

/// A program that was run to see what is wrong with it.
struct CheckedProgram {
    std::string name;
    std::string status;       ///< As in a report; "not run" where its text has errors or cannot be read.
    double cycle_time_s = 0;  ///< Up to the end, or to what ended it.
};

/// {"diagnostics": [...]}: each with file, line, column, end_column, severity, code, text and hint (null
/// where not known), behind {"programs": [...]} where there are any; docs/diagnostics.md.
std::string findings_json(std::span<const text::Diagnostic> diagnostics,
                          std::span<const CheckedProgram> programs);

/// The same as SARIF 2.1.0 (OASIS), which code hosts show beside the lines; rules are the kinds that occur.
std::string findings_sarif(std::span<const text::Diagnostic> diagnostics);

}  // namespace gsim::apps
