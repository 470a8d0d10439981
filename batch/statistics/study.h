#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "batch/statistics/regression.h"
#include "batch/statistics/sample.h"
#include "batch/store/sqlite.h"

namespace gsim::batch {

/// Statistics of many runs of one program on one machine, in the variants of the latest batch.
struct Study {
    std::string program, machine;
    std::uint64_t runs = 0;
    std::uint64_t failed = 0;
    Interval failed_share = {};
    std::vector<std::pair<std::string, std::uint64_t>> causes = {};  ///< Causes of failure, with counts.
    std::vector<double> times_s = {};  ///< Cycle times of those that completed, in the order of their jobs.
    SampleSummary time = {};           ///< For these; its count is 0 if none exist.
    Sensitivity sensitivity = {};      ///< For the cycle time, to numeric settings.
};

/// Returns a study for each program and machine with at least two runs.
Result<std::vector<Study>> read_studies(Database& results);

/// Comparison of two machines, or two batches, by the runs that both have: of the same program with the same
/// settings.
struct Comparison {
    std::string first, second;
    std::uint64_t pairs = 0;
    std::uint64_t faster = 0,
                  slower = 0;  ///< Runs in which the second takes less, and more, time than the first.
    std::uint64_t fails_first = 0, fails_second = 0;  ///< Pairs of which that one alone fails.
    SampleSummary difference_s = {};   ///< The second minus the first, if both completed; its count may be 0.
    double first_s = 0, second_s = 0;  ///< Sums over those.
};
/// Compares each machine of the latest batch with the first one.
Result<std::vector<Comparison>> compare_machines(Database& results);
/// Compares the latest batch with the one of that number before it; 0: with the last one before.
Result<Comparison> compare_batches(Database& results, std::int64_t before);

std::string to_text(const Study& study);
std::string to_text(const Comparison& comparison);
std::string to_json(const std::vector<Study>& studies, const std::vector<Comparison>& comparisons);
/// Returns one page with pictures that needs no other file.
std::string to_html(const std::vector<Study>& studies, const std::vector<Comparison>& comparisons);

}  // namespace gsim::batch
