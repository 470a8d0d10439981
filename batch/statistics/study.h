#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "batch/statistics/regression.h"
#include "batch/statistics/sample.h"
#include "batch/store/sqlite.h"

namespace gsim::batch {

/// What many runs of one program on one machine tell, in the variants of the latest batch.
struct Study {
    std::string program, machine;
    std::uint64_t runs = 0;
    std::uint64_t failed = 0;
    Interval failed_share = {};
    std::vector<std::pair<std::string, std::uint64_t>> causes = {};  ///< Of failures, by how many.
    std::vector<double> times_s = {};  ///< Cycle times of those that completed, in the order of their jobs.
    SampleSummary time = {};           ///< Of these; its count is 0 where there are none.
    Sensitivity sensitivity = {};      ///< Of the cycle time, to settings that are numbers.
};

/// One for each program and machine with two runs at least.
tl::expected<std::vector<Study>, std::string> read_studies(Database& results);

/// Two machines, or two batches, by the runs that both have: of the same program with the same settings.
struct Comparison {
    std::string first, second;
    std::uint64_t pairs = 0;
    std::uint64_t faster = 0, slower = 0;  ///< How often the second one takes less, and more, than the first.
    std::uint64_t fails_first = 0, fails_second = 0;  ///< Pairs of which that one alone fails.
    SampleSummary difference_s =
        {};  ///< The second less the first, where both completed; its count may be 0.
    double first_s = 0, second_s = 0;  ///< Sums over those.
};
/// Each machine of the latest batch with the first one.
tl::expected<std::vector<Comparison>, std::string> compare_machines(Database& results);
/// The latest batch with the one of that number before it; 0: with the last one before.
tl::expected<Comparison, std::string> compare_batches(Database& results, std::int64_t before);

std::string to_text(const Study& study);
std::string to_text(const Comparison& comparison);
std::string to_json(const std::vector<Study>& studies, const std::vector<Comparison>& comparisons);
/// One page with pictures that needs no other file.
std::string to_html(const std::vector<Study>& studies, const std::vector<Comparison>& comparisons);

}  // namespace gsim::batch
