#pragma once

namespace gsim::waterjet {

/// The width of a cut. Rules of this project with numbers that a shop sets (docs/waterjet.md).
struct KerfRule {
    double width_to_tube = 0;  ///< Width at the entry, by the mixing tube's diameter; > 0.
    double taper_mm = 0;       ///< By which each side closes towards the exit at the separation speed; >= 0.

    bool operator==(const KerfRule&) const = default;
};

/// Returns the kerf at the entry, in mm.
double kerf_mm(const KerfRule& rule, double mixing_tube_mm);

/// Returns the narrowing of each side towards the exit, in mm, at most half of the kerf: slower cuts have
/// less taper, in proportion to the speed. `speed_ratio` is the speed as a share of the separation
/// speed.
double taper_mm(const KerfRule& rule, double kerf_mm, double speed_ratio);

/// Returns the kerf at the exit, in mm, never below 0.
double exit_kerf_mm(const KerfRule& rule, double kerf_mm, double speed_ratio);

}  // namespace gsim::waterjet
