#pragma once

#include <array>
#include <string_view>

namespace gsim::batch {

/// Metrics of runs (columns of `run`) that a search may optimise or limit.
inline constexpr std::array<std::string_view, 17> kMetrics{
    "cycle_time_s", "rapid_s",          "feed_s",       "dwell_s",           "rapid_mm",     "feed_mm",
    "energy_j",     "clearance_mm",     "deviation_mm", "joint_speed_share", "violations",   "collisions",
    "warnings",     "cycle_time_max_s", "blocks",       "process_findings",  "lower_bound_s"};

}  // namespace gsim::batch
