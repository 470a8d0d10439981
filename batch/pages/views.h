#pragma once

#include <filesystem>
#include <string>
#include <unordered_set>
#include <vector>

#include <tl/expected.hpp>

#include "batch/pages/night.h"
#include "batch/pages/run_book.h"
#include "batch/work/input_files.h"

namespace gsim::batch {

/// By what pages with finished runs are made.
struct ViewMaker {
    std::string program;  ///< gsim.
    std::string version;  ///< As runs have it: those of another one would come out otherwise.
};

/// Pages that show finished runs, in a folder within that of the other pages. Each is made by a process of
/// its own; what is there already of the same run is not made again.
class Views {
  public:
    Views(const std::string& folder, ViewMaker maker);

    /// The address of a run's page, from the folder of the other pages. The error says why there is none.
    tl::expected<std::string, std::string> make(const RunFacts& facts, const WholeRun& run);

  private:
    tl::expected<std::vector<std::string>, std::string> command_for(const RunFacts& facts,
                                                                    const WholeRun& run);

    std::filesystem::path folder_;
    ViewMaker maker_;
    InputFiles files_;
    std::unordered_set<std::string> names_;

    friend tl::expected<void, std::string> remove_views(const std::string& folder, const Views* kept);
};

/// Removes pages of runs that `kept`, if there is one, has not been asked for. The error is a sentence.
tl::expected<void, std::string> remove_views(const std::string& folder, const Views* kept);

}  // namespace gsim::batch
