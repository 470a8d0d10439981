#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "batch/search/search_plan.h"
#include "batch/store/sqlite.h"

namespace gsim::batch {

/// Results of a run, as in the file of results.
struct RunMetrics {
    std::int64_t run = 0;
    std::string status = {}, cause = {}, message = {}, program = {};
    std::map<std::string, std::optional<double>, std::less<>> metrics = {};  ///< Values of kMetrics.

    bool is_clean() const { return status == "completed" && cause.empty(); }
    double metric(std::string_view name, double fallback = 0) const;
};

/// Returns the runs of a batch in the order of its jobs. The error: some jobs have none.
Result<std::vector<RunMetrics>> read_metrics(Database& results, std::int64_t batch, std::uint64_t jobs);

/// Returns true if a run was not even begun: its program or an input was refused, or its process was lost.
bool was_not_started(const RunMetrics& run);

/// Quality of a variant, over all programs and machines of its plan.
struct Score {
    /// Value of the objective: smaller is better. Empty if a run did not reach its end.
    std::optional<double> value = {};
    double violation = 0;  ///< Size of the violation: 0 if all runs are within all limits.

    bool is_feasible() const { return violation == 0; }
    /// An allowed variant is better, otherwise the one closer to that (Deb 2000).
    bool operator<(const Score& other) const {
        if (violation != other.violation) return violation < other.violation;
        return value && (!other.value || *value < *other.value);
    }
};

/// Returns the score. `start`: the same runs of the unchanged files; a variant must not have more process
/// findings.
Score compute_score(const SearchPlan& search, std::span<const RunMetrics> runs,
                    std::span<const RunMetrics> start);

/// Returns an error if a completed run lacks a metric of the objective or of a limit.
std::optional<Error> find_missing_metric(const SearchPlan& search, std::span<const RunMetrics> runs);

}  // namespace gsim::batch
