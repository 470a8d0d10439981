#pragma once

#include <Eigen/Core>
#include <string>

#include "base/error.h"

namespace gsim::script {

/// Tolerances of a dialect for the arcs of a program.
struct ArcRules {
    double radii_tolerance_mm = 0.05;       ///< By which the radii of start and end may differ,
    double radii_tolerance_inch_mm = 0.05;  ///< if the program is in inches,
    double radii_tolerance_share = 0;       ///< or by this share of the greater radius, if that is more,
    double radii_tolerance_growth = 1;      ///< up to so many times the former.
    double max_radius_shortfall_mm = 0.05;  ///< R may be too short for the end by this much.
    double turns_tolerance = 0;             ///< Max deviation of turns from an integer.

    /// Returns the max difference of radii if the larger one is `radius_mm`.
    double radii_tolerance(double radius_mm, bool inches) const;
};

/// Known values of an arc before its circle: points in its plane, in mm, and the sense of travel.
struct ArcEnds {
    Eigen::Vector2d start;
    Eigen::Vector2d end;
    bool ccw;
};

struct ArcSolution {
    Eigen::Vector2d center;  ///< mm, in the plane.
    double sweep_rad;        ///< > 0, in the sense of travel; a full circle if the ends coincide.
};

/// Returns the angle in (0, 2 pi] from the start to the end as seen from the centre, in the sense of travel.
double swept_rad(const ArcEnds& ends, const Eigen::Vector2d& center);

// Four definitions of an arc. The errors are messages for the programmer. Values that are no numbers give a
// solution that is none.

Result<ArcSolution> arc_by_center(const ArcEnds& ends, const Eigen::Vector2d& center, const ArcRules& rules,
                                  bool inches);
/// Returns the arc of at most half a turn for a radius above 0, the other arc for one below 0.
Result<ArcSolution> arc_by_radius(const ArcEnds& ends, double radius_mm, const ArcRules& rules);
Result<ArcSolution> arc_by_angle(const ArcEnds& ends, double angle_rad);
/// Returns the end of an arc of that angle about the centre; the end in `ends` is ignored.
Eigen::Vector2d end_by_angle(const ArcEnds& ends, const Eigen::Vector2d& center, double angle_rad);

/// Converts AR=, degrees above 0 and up to 360, to radians.
Result<double> arc_angle_rad(double degrees);
/// Returns the sweep that P turns, an integer from 1 on, add to an arc.
Result<double> additional_turns_rad(double turns, const ArcRules& rules);

}  // namespace gsim::script
