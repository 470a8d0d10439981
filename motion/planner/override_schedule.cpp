#include "motion/planner/override_schedule.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace gsim::motion {

namespace {

/// Returns the first change after an instant. A segment that is cut at a change ends there except for
/// rounding.
auto next_change(const std::vector<OverrideChange>& changes, double t_s) {
    constexpr double kInstantTolerance_s = 1e-9;
    return std::upper_bound(
        changes.begin(), changes.end(), t_s + kInstantTolerance_s,
        [](double instant_s, const OverrideChange& change) { return instant_s < change.at_s; });
}

}  // namespace

Overrides OverrideSchedule::at(double t_s) const {
    const auto next = next_change(changes_, t_s);
    return next == changes_.begin() ? Overrides{} : std::prev(next)->to;
}

double OverrideSchedule::next_change_s(double t_s) const {
    const auto next = next_change(changes_, t_s);
    return next == changes_.end() ? std::numeric_limits<double>::infinity() : next->at_s;
}

double OverrideSchedule::release_time_s(double t_s, const EnabledOverrides& enabled_overrides,
                                        bool is_rapid) const {
    while (enabled_overrides.share(at(t_s), is_rapid) <= 0) t_s = next_change_s(t_s);
    return t_s;
}

}  // namespace gsim::motion
