#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "batch/pages/night.h"
#include "batch/pages/run_book.h"

namespace gsim::batch {

/// What has become of the cases since the batch before, by their places in Night::cases. A case may stand in
/// several of these lists.
struct Changes {
    std::vector<std::size_t> newly_failing, mended;
    std::vector<std::size_t> other_times;     ///< The greatest difference first.
    std::vector<std::size_t> other_findings;  ///< Another cause, or other findings, without those above.
    std::vector<std::size_t> fresh, gone;
    std::size_t same = 0;  ///< Cases of both batches that are in none of the lists.
};

/// Nothing where there is no batch before.
tl::expected<Changes, std::string> find_changes(const Night& night, RunBook& book);

/// The time now less that before, where both have one.
double time_difference_s(const Case& of);

/// Why a case was run anew, in words: what of all that the first run read, or was told, is another one for
/// the second one. Empty: it is one run, or nothing of that has changed.
std::vector<std::string> why_anew(const WholeRun& before, const WholeRun& now);

}  // namespace gsim::batch
