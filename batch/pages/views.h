#pragma once

#include <filesystem>
#include <string>
#include <unordered_set>
#include <vector>

#include "base/error.h"
#include "batch/pages/nightly_report.h"
#include "batch/pages/run_history.h"
#include "batch/work/input_files.h"

namespace gsim::batch {

/// Tool that makes the pages with finished runs.
struct ViewGenerator {
    std::string program;  ///< gsim.
    std::string version;  ///< As runs have it: those of another one would come out otherwise.
};

/// Pages that show finished runs, in a folder within that of the other pages. A separate process makes each
/// one; an existing page of the same run is not made again.
class Views {
  public:
    Views(const std::string& folder, ViewGenerator maker);

    /// Returns the address of a run's page, relative to the folder of the other pages. The error says why it
    /// does not exist.
    Result<std::string> make(const RunSummary& facts, const RunDetails& run);

  private:
    Result<std::vector<std::string>> make_command(const RunSummary& facts, const RunDetails& run);

    std::filesystem::path folder_;
    ViewGenerator generator_;
    InputFiles files_;
    std::unordered_set<std::string> names_;

    friend Result<void> remove_views(const std::string& folder, const Views* current);
};

/// Removes the pages that are not among those of `current`; null: all pages.
Result<void> remove_views(const std::string& folder, const Views* current);

}  // namespace gsim::batch
