#pragma once

#include <string>

#include "batch/pages/nightly_report.h"

namespace gsim::batch {

/// Returns the history of a case in the previous batches, as markup: when it was last without an error, a
/// line of its times, and a table.
std::string history_text(const NightlyReport& report, const Case& of);

}  // namespace gsim::batch
