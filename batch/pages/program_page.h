#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batch/pages/night.h"
#include "batch/pages/run_book.h"

namespace gsim::batch {

/// A case with all that its part of a page tells.
struct CaseDetails {
    const Case* of = nullptr;
    WholeRun now;
    std::vector<std::string> why_anew = {};  ///< Where it has another run than the batch before.
    std::string view = {};         ///< Address of the page with its finished run, where there is one,
    std::string why_no_view = {};  ///< or why not; nothing where none was wanted.
};

/// The page of a program: its cases in a table, and those with details one by one.
std::string program_page(const Night& night, const ProgramCases& program,
                         const std::vector<CaseDetails>& details);

}  // namespace gsim::batch
