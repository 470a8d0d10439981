#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "tests/conformance/corpus.h"
#include "tests/conformance/move.h"
#include "tests/conformance/scratch_folder.h"
#include "tests/conformance/tool_rows.h"

namespace gsim::conformance {

/// Options for gsim.
struct GsimOptions {
    std::string gsim_run = "gsim-run";  ///< The program.
    std::string machine;                ///< Machine file.
    std::vector<std::string> extra;     ///< Further options for it.
};

/// Runs recorded programs.
class GsimRuns {
  public:
    GsimRuns(GsimOptions options, const std::vector<ToolRow>& tools);

    /// The moves of a program in the dialect rs274ngc; the error is the first one that gsim-run reports.
    Result<std::vector<Move>> moves(const Recorded& recorded) const;

  private:
    Result<std::filesystem::path> place(const Recorded& recorded) const;
    std::string without_paths(std::string message) const;

    GsimOptions options_;
    ScratchFolder scratch_;
    std::filesystem::path machine_data_;
};

/// Returns the output of a command (found by PATH) that reads `input`; the error says how it failed.
Result<std::string> command_output(const std::vector<std::string>& command,
                                   const std::filesystem::path& input);

/// Returns a file's text; a file with a name ending in .gz is unpacked by gzip.
Result<std::string> read_text(const std::filesystem::path& file);

}  // namespace gsim::conformance
