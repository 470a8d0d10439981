#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "batch/work/job.h"

namespace gsim::batch {

/// The file that view_command() writes.
inline constexpr std::string_view kViewFile = "run.html";

/// What a run was told, as the results have it.
struct RunTold {
    std::string program, machine;
    std::string options = "{}", settings = "{}";  ///< JSON.
};
RunTold told_of(const Job& job);

/// A command by which a run is seen, from where the batch was run.
struct OpenCommand {
    std::vector<std::string>
        words;  ///< None: there is no such command, as for paths, which are written first.
    std::vector<std::string> left_out;  ///< Options and settings of the run that it has no words for.
};

/// The studio with program and machine: it serves one folder, which must have all files.
OpenCommand studio_command(const RunTold& run);
/// A page with the finished run.
OpenCommand view_command(const RunTold& run);
/// The run itself.
OpenCommand run_command(const RunTold& run);

/// A word as a shell reads it.
std::string shell_word(std::string_view word);
/// A command likewise.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace gsim::batch
