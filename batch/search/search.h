#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/error.h"
#include "batch/search/evaluator.h"
#include "batch/search/score.h"
#include "batch/search/search_plan.h"

namespace gsim::batch {

/// Variant that was tried.
struct Trial {
    std::vector<SettingValue> settings;  ///< Empty at the start: files as they are.
    Score score;
    std::vector<RunMetrics> runs;  ///< For each program on each machine.
};

/// State of a search.
struct SearchState {
    std::int64_t search = 0;  ///< Its number in the results.
    Trial start, best;        ///< The best one may be the start.
    std::uint64_t best_number = 0;
    std::uint64_t trials = 0;      ///< Variants, the start among them.
    std::uint64_t feasible = 0;    ///< Those with all runs within all limits.
    std::uint64_t generation = 0;  ///< 0: those that are spread evenly.
    bool complete = false;         ///< Else it was cut off.
};

/// Searches for the best variant: the files as they are first, then variants that are spread evenly (a Latin
/// hypercube), then an evolution from the best of these. If that has converged, another evolution starts at a
/// random point with twice as many trials at once. All runs are in the results, in batches, and each trial is
/// in the tables `search` and `search_run`. The same plan tries the same variants, so that an interrupted
/// search continues with the existing runs.
Result<SearchState> search_best(const SearchPlan& search, const std::string& results,
                                const Evaluate& evaluate,
                                const std::function<void(const SearchState&)>& progress);

}  // namespace gsim::batch
