#pragma once

#include <optional>

namespace gsim::waterjet {

/// How long the jet takes to come through at one place. A rule of this project with numbers that a shop sets
/// (docs/waterjet.md).
struct PierceRule {
    double factor = 0;   ///< Times the thickness over the separation speed; > 0.
    double least_s = 0;  ///< However thin the material is; >= 0.
    /// What a pierce takes of that while the nozzle moves, which leads the jet that comes back away; 0 < ..
    /// <= 1. None: not known.
    std::optional<double> moving_share = std::nullopt;

    bool operator==(const PierceRule&) const = default;
};

/// In s, with the nozzle at rest: the jet that comes back from the bottom takes most of its strength, so that
/// it goes down slower, by the rule's factor, than it goes forward when it just separates the material.
double pierce_s(const PierceRule& rule, double thickness_mm, double separation_speed_mm_min);

}  // namespace gsim::waterjet
