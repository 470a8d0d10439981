#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "batch/work/job.h"

namespace gsim::batch {

/// File that view_command() writes.
inline constexpr std::string_view kViewFile = "run.html";

/// Inputs and options of a run, as in the results.
struct RunInputs {
    std::string program, machine;
    std::string options = "{}", settings = "{}";  ///< JSON.
};
RunInputs run_inputs(const Job& job);

/// Command to view a run, for the folder in which the batch was run.
struct ViewCommand {
    std::vector<std::string>
        words;  ///< Empty: no such command exists, as for paths, which are written first.
    std::vector<std::string> left_out;  ///< Options and settings of the run that it has no words for.
};

/// Returns the command for the studio with program and machine: it serves one folder, which must contain all
/// files.
ViewCommand studio_command(const RunInputs& run);
/// Returns the command for a page with the finished run.
ViewCommand view_command(const RunInputs& run);
/// Returns the command for the run itself.
ViewCommand run_command(const RunInputs& run);

/// Quotes a word for a shell.
std::string shell_word(std::string_view word);
/// Quotes a command likewise.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace gsim::batch
