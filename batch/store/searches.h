#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/error.h"
#include "batch/store/sqlite.h"

namespace gsim::batch {

/// Trial of a search, as it is stored: one row for each of its runs.
struct TrialRow {
    std::uint64_t number = 0;  ///< Within the search; 0: the start.
    std::int64_t run = 0;
    std::uint64_t generation = 0;
    std::optional<double> value = {};
    double violation = 0;
};

/// Begins a search in a file of results that has its tables. No other process writes meanwhile.
Result<std::int64_t> begin_search(Database& results, const std::string& plan, const std::string& objective,
                                  std::uint64_t seed);
Result<void> add_trials(Database& results, std::int64_t search, std::span<const TrialRow> rows);
/// Ends a search, with the number of the best trial.
Result<void> end_search(Database& results, std::int64_t search, std::uint64_t best);

}  // namespace gsim::batch
