#pragma once

#include <string>
#include <vector>

#include "batch/pages/program_page.h"

namespace gsim::batch {

/// Reasons as markup; where there are none a word for that.
std::string reasons_text(const std::vector<std::string>& reasons);

/// The part of a program's page on one machine with one variant of the settings: figures, findings, what has
/// changed, files, history, and how to see it run.
std::string case_text(const Night& night, const CaseDetails& details);

}  // namespace gsim::batch
