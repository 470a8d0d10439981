#pragma once

#include <string>
#include <vector>

#include "batch/pages/program_page.h"

namespace gsim::batch {

/// Returns reasons as markup, or a word for an empty list.
std::string reasons_text(const std::vector<std::string>& reasons);

/// Returns the part of a program's page for one machine and one variant of the settings: metrics, findings,
/// changes, files, history, and the command to view the run.
std::string case_text(const NightlyReport& report, const CaseDetails& details);

}  // namespace gsim::batch
