#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "batch/search/best_files.h"
#include "batch/search/search.h"

namespace gsim::batch {

/// Verification runs of the best variant and the start, with reports and lower bounds.
struct VerificationRun {
    struct BoundedObjective {
        std::optional<double> value = {};          ///< Objective.
        std::optional<double> lower_bound_s = {};  ///< Sum over its runs, if all have one.
    };
    BoundedObjective start, best;
    std::vector<Job> files;  ///< Files of the best variant, as they were written; empty: no folder was given.
};

/// Runs the start and the best variant once more: the latter from the files that are written into `folder`,
/// if it is given. The error: a metric of a run differs from that in the search, a file cannot be written, or
/// the verification was cut off.
Result<VerificationRun> verify_best(const SearchPlan& search, const SearchState& state,
                                    const std::string& results, const std::string& folder,
                                    const Evaluate& evaluate);

}  // namespace gsim::batch
