#pragma once

#include <vector>

#include "runtime/report/report.h"

namespace gsim::simulation {

/// Returns everything that a report contains, one diagnostic each, in the order: the program's text, the
/// reason why the run did not complete, limits and zones that were passed, the process, contacts and near
/// misses in the cell, warnings.
std::vector<text::Diagnostic> report_diagnostics(const Report& report);

}  // namespace gsim::simulation
