#pragma once

#include <optional>

namespace gsim::waterjet {

/// The time to pierce the material at one position. A rule of this project with numbers that a shop sets
/// (docs/waterjet.md).
struct PierceRule {
    double factor = 0;  ///< Times the thickness over the separation speed; > 0.
    double min_s = 0;   ///< However thin the material is; >= 0.
    /// Share of that time for a pierce while the nozzle moves, which deflects the returning jet; 0 < .. <= 1.
    /// None: not known.
    std::optional<double> dynamic_pierce_share = std::nullopt;

    bool operator==(const PierceRule&) const = default;
};

/// Returns the time in s, with the nozzle at standstill. The jet that returns from the bottom consumes most
/// of its power. So it moves down slower, by the rule's factor, than it moves forward when it just separates
/// the material.
double pierce_s(const PierceRule& rule, double thickness_mm, double separation_speed_mm_min);

}  // namespace gsim::waterjet
