#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/error.h"
#include "batch/pages/nightly_report.h"
#include "batch/pages/run_history.h"

namespace gsim::batch {

/// Changes of the cases since the previous batch, by their indices in NightlyReport::cases. A case may be in
/// several of these lists.
struct Changes {
    std::vector<std::size_t> newly_failing, fixed;
    std::vector<std::size_t> changed_times;     ///< The greatest difference first.
    std::vector<std::size_t> changed_findings;  ///< Another cause, or other findings, without those above.
    std::vector<std::size_t> added, removed;
    std::size_t same = 0;  ///< Cases of both batches that are in no list.
};

/// Finds the changes; empty if no previous batch exists.
Result<Changes> find_changes(const NightlyReport& report, RunHistory& run_history);

/// Returns the time now minus that before, if both have one.
double time_difference_s(const Case& of);

/// Returns the reasons why a case was run again, in words: the inputs and arguments of the first run that
/// differ for the second one. Empty: it is one run, or no input has changed.
std::vector<std::string> rerun_reasons(const RunDetails& before, const RunDetails& now);

}  // namespace gsim::batch
