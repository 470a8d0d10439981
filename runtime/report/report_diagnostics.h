#pragma once

#include <vector>

#include "runtime/report/report.h"

namespace gsim::simulation {

/// All that a report has to tell of, one diagnostic each, in the order: the program's text, why the run did
/// not complete, limits and zones that were passed, the process, contacts and near misses in the cell,
/// warnings.
std::vector<text::Diagnostic> diagnostics_of(const Report& report);

}  // namespace gsim::simulation
