#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batch/pages/nightly_report.h"
#include "batch/pages/run_history.h"

namespace gsim::batch {

/// Case with the complete content of its part of a page.
struct CaseDetails {
    const Case* of = nullptr;
    RunDetails now;
    std::vector<std::string> rerun_reasons = {};  ///< If it has another run than the previous batch.
    std::string view = {};                        ///< Address of the page with its finished run, if any,
    std::string view_error = {};                  ///< or why not; empty if none was wanted.
};

/// Returns the page of a program: its cases in a table, and those with details one by one.
std::string program_page(const NightlyReport& report, const ProgramCases& program,
                         const std::vector<CaseDetails>& details);

}  // namespace gsim::batch
