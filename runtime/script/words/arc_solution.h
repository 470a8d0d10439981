#pragma once

#include <Eigen/Core>
#include <string>

#include <tl/expected.hpp>

namespace gsim::script {

/// How exactly a program must give its arcs; what a dialect asks for.
struct ArcRules {
    double radii_tolerance_mm = 0.05;       ///< By which the radii of start and end may differ,
    double radii_tolerance_inch_mm = 0.05;  ///< where the program is in inches,
    double radii_tolerance_share = 0;       ///< or by this share of the greater radius, if that is more,
    double radii_tolerance_growth = 1;      ///< up to so many times the former.
    double short_radius_mm = 0.05;          ///< By which R may be too short for the way to the end.
    double turns_tolerance = 0;             ///< By which a number of turns may be off a whole one.

    /// By how much radii may differ of which the greater one is `radius_mm`.
    double radii_tolerance(double radius_mm, bool inches) const;
};

/// What is known of an arc before its circle: points in its plane, in mm, and the sense of travel.
struct ArcEnds {
    Eigen::Vector2d start;
    Eigen::Vector2d end;
    bool ccw;
};

struct ArcSolution {
    Eigen::Vector2d center;  ///< mm, in the plane.
    double sweep_rad;        ///< > 0, in the sense of travel; a full circle where the ends coincide.
};

/// The angle in (0, 2 pi] from the start to the end as seen from the centre, in the sense of travel.
double swept_rad(const ArcEnds& ends, const Eigen::Vector2d& center);

// The four ways to give an arc. The errors are sentences for the programmer. Values that are no numbers give
// a solution that is none.

tl::expected<ArcSolution, std::string> arc_by_center(const ArcEnds& ends, const Eigen::Vector2d& center,
                                                     const ArcRules& rules, bool inches);
/// A radius above 0 is the arc of at most half a turn, one below 0 the other arc.
tl::expected<ArcSolution, std::string> arc_by_radius(const ArcEnds& ends, double radius_mm,
                                                     const ArcRules& rules);
tl::expected<ArcSolution, std::string> arc_by_angle(const ArcEnds& ends, double angle_rad);
/// Where an arc of that angle about the centre ends; the end in `ends` is not looked at.
Eigen::Vector2d end_by_angle(const ArcEnds& ends, const Eigen::Vector2d& center, double angle_rad);

/// AR=: degrees above 0 and up to 360, in radians.
tl::expected<double, std::string> arc_angle_rad(double degrees);
/// What P turns, a whole number from 1 on, add to the sweep of an arc.
tl::expected<double, std::string> further_turns_rad(double turns, const ArcRules& rules);

}  // namespace gsim::script
