#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "batch/store/sqlite.h"

namespace gsim::batch {

/// A trial of a search, as it is kept: one for each of its runs.
struct TrialRow {
    std::uint64_t number = 0;  ///< Within the search; 0: the start.
    std::int64_t run = 0;
    std::uint64_t generation = 0;
    std::optional<double> value = {};
    double violation = 0;
};

/// Searches in a file of results that has its tables. Nothing else writes meanwhile.
tl::expected<std::int64_t, std::string> begin_search(Database& results, const std::string& plan,
                                                     const std::string& objective, std::uint64_t seed);
SqlDone add_trials(Database& results, std::int64_t search, std::span<const TrialRow> rows);
/// With the number of the best trial.
SqlDone end_search(Database& results, std::int64_t search, std::uint64_t best);

}  // namespace gsim::batch
