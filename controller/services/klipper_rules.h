#pragma once

namespace gsim::rrs {

/// Rules of PlannerKind::klipper alone.
struct KlipperRules {
    /// Min length on the arc of a chord. Arcs become the largest number of equal chords of that length; 0:
    /// the controller knows no arcs.
    double arc_resolution_mm = 0;
    double square_corner_velocity_mm_s = 5;  ///< The speed at a right angle.
    /// Min share of a move, or of several that speed up and slow down again, that is passed at one speed.
    double minimum_cruise_ratio = 0.5;

    bool operator==(const KlipperRules&) const = default;
};

}  // namespace gsim::rrs
