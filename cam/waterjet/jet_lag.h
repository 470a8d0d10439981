#pragma once

#include <array>

namespace gsim::waterjet {

/// How far the jet trails behind the nozzle, and how much of that may show in the contour. These are rules of
/// this project with numbers that a shop sets (docs/waterjet.md); no published ones were at hand.
struct LagRule {
    double lag_to_thickness = 0;               ///< Of a cut at the separation speed.
    double exponent = 0;                       ///< The lag goes with this power of the speed; > 0.
    std::array<double, 5> contour_error_mm{};  ///< Allowed at the exit, for the qualities 1 .. 5.
    double least_feed_share = 0;               ///< Of the cutting speed; no place is cut slower. 0 < .. <= 1

    bool operator==(const LagRule&) const = default;
};

/// The straight cut that a lag belongs to.
struct LagState {
    double thickness_mm = 0;
    double separation_speed_mm_min = 0;
};

/// How far the jet leaves the material behind where it enters, in mm.
double lag_mm(const LagRule& rule, const LagState& cut, double speed_mm_min);

/// The speed at which the jet lags by `lag_mm`: the inverse of the function above.
double speed_of_lag_mm_min(const LagRule& rule, const LagState& cut, double lag_mm);

/// The error that the rule allows at a quality of 1 .. 5; between whole ones it goes in a straight line.
double contour_error_mm(const LagRule& rule, double quality);

/// The longest lag on an arc: a jet that trails by L along the tangent leaves a circle of radius R by
/// sqrt(R^2 + L^2) - R, which shall be at most the error E, so L = sqrt((R + E)^2 - R^2).
double lag_allowed_on_arc_mm(double radius_mm, double error_mm);

/// The longest lag in a corner, where the direction turns by `turn_rad` (of either sign): the exit cuts the
/// corner off from L before it to L behind it, by L sin(turn / 2), which shall be at most the error. Infinite
/// where nothing turns; NaN counts as pi.
double lag_allowed_in_corner_mm(double turn_rad, double error_mm);

}  // namespace gsim::waterjet
