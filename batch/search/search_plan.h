#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "batch/plan/plan.h"

namespace gsim::batch {

/// Metric of runs with its weight. The minimum is best, so a weight below 0 makes larger values better.
struct Weight {
    std::string metric;  ///< One of kMetrics.
    double weight = 1;
};

/// Limits of a metric, for each run.
struct MetricLimit {
    std::string metric;
    std::optional<double> min = {}, max = {};
};

/// Goal of a search: the values of a plan's settings that minimise the sum of the objective over its programs
/// and machines. Only values count with which all runs are without an error and within the limits.
struct SearchPlan {
    Plan plan;
    std::vector<Weight> objective;
    std::vector<MetricLimit> limits;
    std::uint64_t variants = 200;  ///< Max number to be tried.
    std::uint64_t first = 0;  ///< Number of these spread evenly at first; 0: as many as the settings need.
    std::uint64_t population = 0;  ///< Variants then tried at once; 0: likewise.
    std::uint64_t seed = 1;
    std::vector<std::string> warnings = {};  ///< About the file, each as "file:line:column: message".
};

/// Reads a plan with its search part (docs/optimise.md). The error begins with its source location.
Result<SearchPlan> read_search(std::string_view toml_text, const std::string& file_name);

}  // namespace gsim::batch
