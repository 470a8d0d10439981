#pragma once

#include <vector>

namespace gsim::rrs {

/// Operator overrides that a controller accepts, in percent of the programmed values.
struct OverrideRules {
    double feed_min_percent = 0;
    double feed_max_percent = 200;
    double rapid_max_percent = 100;
    /// The permitted values of a rapid override, rising; empty: any up to rapid_max_percent.
    std::vector<double> rapid_percents;
    double spindle_min_percent = 0;
    double spindle_max_percent = 200;
    double delay_s = 0;               ///< Delay until a change acts: prepared motion continues.
    bool override_probe_feed = true;  ///< The feed override counts for probing moves, too.
    /// The feed override for which the speeds of junctions are planned, whatever its setting (LinuxCNC:
    /// [DISPLAY] MAX_FEED_OVERRIDE).
    double planned_feed_percent = 100;

    bool operator==(const OverrideRules&) const = default;
};

}  // namespace gsim::rrs
