#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "batch/search/evaluator.h"
#include "batch/search/score.h"
#include "batch/search/search_plan.h"

namespace gsim::batch {

/// A variant that was tried.
struct Trial {
    std::vector<SettingValue> settings;  ///< None at the start: files as they are.
    Score score;
    std::vector<RunFigures> runs;  ///< Of each program on each machine.
};

/// What a search has come to.
struct SearchState {
    std::int64_t search = 0;  ///< Its number in the results.
    Trial start, best;        ///< The best one may be the start.
    std::uint64_t best_number = 0;
    std::uint64_t tried = 0;       ///< Variants, the start among them.
    std::uint64_t allowed = 0;     ///< Of these, with all runs within all limits.
    std::uint64_t generation = 0;  ///< 0: those that are spread evenly.
    bool whole = false;            ///< Else it was cut off.
};

/// Looks for the best variant: the files as they are first, then variants that are spread evenly (a Latin
/// hypercube), then an evolution from the best of these; where that has drawn itself together, another one
/// from a place by lot with twice as many at once. All runs are in the results, in batches, and each trial in
/// the tables `search` and `search_run`. The same plan tries the same variants, so that a search which was
/// cut off goes on by what is there already. The error is a sentence.
tl::expected<SearchState, std::string> search_best(const SearchPlan& search, const std::string& results,
                                                   const Evaluate& evaluate,
                                                   const std::function<void(const SearchState&)>& progress);

}  // namespace gsim::batch
