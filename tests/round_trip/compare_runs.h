#pragma once

#include <set>
#include <string>

#include "tests/round_trip/run_record.h"

namespace gsim::round_trip {

/// Reasons why the second of two runs differs from the first: empty if it does not. Positions may differ by
/// 1e-3 mm or deg, times by 0.1 % or 2 ms.
struct Differences {
    std::string positions, times, events;

    bool none() const { return positions.empty() && times.empty() && events.empty(); }
};

/// The moves: each end, in its order, and how it was reached. Moves below the tolerance may be missing, and
/// an arc may come as several, or as lines that keep to it.
std::string compare_positions(const RunRecord& first, const RunRecord& second);
/// The time of the run.
std::string compare_times(const RunRecord& first, const RunRecord& second);
/// Kind and detail of each event in their order, and its time. The dialects call some switches by different
/// names: M7, M8 and M9 are the same ones. What a probe has found is no event to be repeated, and actions
/// that the writer has named as `unsaid` are left out.
std::string compare_events(const RunRecord& first, const RunRecord& second,
                           const std::set<std::string>& unsaid);

}  // namespace gsim::round_trip
