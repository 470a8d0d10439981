#pragma once

#include <functional>
#include <map>
#include <string>

namespace gsim::rrs {

/// Condition under which the controller waits at a word until all moves have been made.
enum class StopRule {
    always,
    on_change,  ///< If the word changes something.
    never,
};

/// Words at which the controller stands still, and for how long.
struct StandstillRules {
    /// Differences of this controller from others in the words that stop it, by word as it is printed
    /// ("G92.1"; docs/stops.md).
    std::map<std::string, StopRule, std::less<>> stops;
    double dwell_s = 0;       ///< Time at each stop that waits for the program's next block (dwell, M code).
    double dwell_step_s = 0;  ///< Dwells are raised to a multiple of it; 0: they are not.

    bool operator==(const StandstillRules&) const = default;
};

}  // namespace gsim::rrs
