#pragma once

#include <filesystem>
#include <string>
#include <unordered_set>
#include <vector>

#include <tl/expected.hpp>

#include "batch/pages/nightly_report.h"
#include "batch/pages/run_history.h"
#include "batch/work/input_files.h"

namespace gsim::batch {

/// Tool that makes the pages with finished runs.
struct ViewMaker {
    std::string program;  ///< gsim.
    std::string version;  ///< As runs have it: those of another one would come out otherwise.
};

/// Pages that show finished runs, in a folder within that of the other pages. A separate process makes each
/// one; an existing page of the same run is not made again.
class Views {
  public:
    Views(const std::string& folder, ViewMaker maker);

    /// Returns the address of a run's page, relative to the folder of the other pages. The error says why it
    /// does not exist.
    tl::expected<std::string, std::string> make(const RunFacts& facts, const RunDetails& run);

  private:
    tl::expected<std::vector<std::string>, std::string> make_command(const RunFacts& facts,
                                                                     const RunDetails& run);

    std::filesystem::path folder_;
    ViewMaker maker_;
    InputFiles files_;
    std::unordered_set<std::string> names_;

    friend tl::expected<void, std::string> remove_views(const std::string& folder, const Views* current);
};

/// Removes pages of runs that were not requested from `kept`, if it is given. The error is a message.
tl::expected<void, std::string> remove_views(const std::string& folder, const Views* current);

}  // namespace gsim::batch
