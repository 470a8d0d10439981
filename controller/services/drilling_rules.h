#pragma once

namespace gsim::rrs {

/// Drilling cycles of RS274/NGC.
struct DrillingRules {
    double peck_clearance_mm = 0.254;  ///< G73 backs off by it, and G83 comes back by rapid to as far above.
    double peck_dwell_s = 0;           ///< G73 and G83 wait at the bottom of each peck.
    /// G83 leaves the hole as after the last peck, and feeds the full distance down.
    bool pecks_feed_down = false;
    bool boring_cycles = true;  ///< G85, G86 and G89 bore; else they are read without motion.

    bool operator==(const DrillingRules&) const = default;
};

}  // namespace gsim::rrs
