#pragma once

#include <array>

namespace gsim::waterjet {

/// Lag of the jet's exit behind the nozzle, and the share of it that may be visible in the contour. These are
/// rules of this project with numbers that a shop sets (docs/waterjet.md); no published ones were at hand.
struct LagRule {
    double lag_to_thickness = 0;               ///< Lag of a cut at the separation speed.
    double exponent = 0;                       ///< The lag is proportional to this power of the speed; > 0.
    std::array<double, 5> contour_error_mm{};  ///< Allowed at the exit, for the qualities 1 .. 5.
    double min_feed_share = 0;                 ///< Min share of the cutting speed anywhere. 0 < .. <= 1

    bool operator==(const LagRule&) const = default;
};

/// The straight cut that a lag belongs to.
struct StraightCut {
    double thickness_mm = 0;
    double separation_speed_mm_min = 0;
};

/// Returns the distance of the jet's exit behind its entry, in mm.
double lag_mm(const LagRule& rule, const StraightCut& cut, double speed_mm_min);

/// Returns the speed at which the jet lags by `lag_mm`: the inverse of the function above.
double speed_for_lag_mm_min(const LagRule& rule, const StraightCut& cut, double lag_mm);

/// Returns the error that the rule allows at a quality of 1 .. 5; values between integers are interpolated
/// linearly.
double contour_error_mm(const LagRule& rule, double quality);

/// Returns the longest lag on an arc. A jet that lags by L along the tangent deviates from a circle of radius
/// R by sqrt(R^2 + L^2) - R, which may be at most the error E, so L = sqrt((R + E)^2 - R^2).
double lag_allowed_on_arc_mm(double radius_mm, double error_mm);

/// Returns the longest lag in a corner where the direction turns by `turn_rad` (of either sign). The exit
/// cuts the corner off from L before it to L past it, by L sin(turn / 2), which may be at most the error.
/// Infinite without a turn; NaN counts as pi.
double lag_allowed_in_corner_mm(double turn_rad, double error_mm);

}  // namespace gsim::waterjet
