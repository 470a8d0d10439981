#pragma once

#include <string>
#include <vector>

#include "batch/pages/run_book.h"

namespace gsim::batch {

/// A command by which a person sees a run, to be typed where the batch was run.
struct OpenCommand {
    std::string line;                   ///< For a shell; empty: there is none.
    std::vector<std::string> left_out;  ///< Options and settings of the run that it has no words for.
};

/// The studio with program and machine: it serves one folder, which must have all files.
OpenCommand studio_command(const WholeRun& run);
/// A page with the finished run.
OpenCommand view_command(const WholeRun& run);

}  // namespace gsim::batch
