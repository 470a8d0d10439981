#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batch/pages/night.h"
#include "batch/pages/run_book.h"

namespace gsim::batch {

/// Case with the complete content of its part of a page.
struct CaseDetails {
    const Case* of = nullptr;
    WholeRun now;
    std::vector<std::string> why_anew = {};  ///< If it has another run than the previous batch.
    std::string view = {};                   ///< Address of the page with its finished run, if any,
    std::string why_no_view = {};            ///< or why not; empty if none was wanted.
};

/// Returns the page of a program: its cases in a table, and those with details one by one.
std::string program_page(const Night& night, const ProgramCases& program,
                         const std::vector<CaseDetails>& details);

}  // namespace gsim::batch
