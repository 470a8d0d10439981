#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "batch/search/best_files.h"
#include "batch/search/search.h"

namespace gsim::batch {

/// What the best variant and the start come to in runs of their own, with reports and lower bounds.
struct Proof {
    struct Bounded {
        std::optional<double> value = {};          ///< Of the objective.
        std::optional<double> lower_bound_s = {};  ///< Sum over its runs, where all have one.
    };
    Bounded start, best;
    std::vector<Job> files;  ///< Of the best variant, as they were written; empty: no folder was given.
};

/// Runs the start and the best variant once more: the latter from the files that are written into `folder`,
/// where one is given. The error: any figure of a run is another one than the search has, or a file cannot be
/// written, or it was cut off.
tl::expected<Proof, std::string> prove(const SearchPlan& search, const SearchState& state,
                                       const std::string& results, const std::string& folder,
                                       const Evaluate& evaluate);

}  // namespace gsim::batch
