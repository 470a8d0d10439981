#pragma once

#include <vector>

namespace gsim::rrs {

/// What a controller takes of its operator's overrides, in percent of what is programmed.
struct OverrideRules {
    double feed_min_percent = 0;
    double feed_max_percent = 200;
    double rapid_max_percent = 100;
    /// The values that a rapid override has, rising; empty: any up to rapid_max_percent.
    std::vector<double> rapid_percents;
    double spindle_min_percent = 0;
    double spindle_max_percent = 200;
    double delay_s = 0;          ///< Until a change acts: motion that is prepared goes on.
    bool feed_of_probes = true;  ///< The feed override counts for probing moves, too.
    /// The feed override for which the speeds of junctions are planned, whatever it is turned to (LinuxCNC:
    /// [DISPLAY] MAX_FEED_OVERRIDE).
    double planned_feed_percent = 100;

    bool operator==(const OverrideRules&) const = default;
};

}  // namespace gsim::rrs
