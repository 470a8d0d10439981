#pragma once

#include <Eigen/Core>

namespace gsim::motion {

/// Lowest and highest value of a quantity on the path.
struct Range {
    double min = 0;
    double max = 0;
};

/// Max rounding difference between the bounds of an arc and its points.
inline constexpr double kArcRounding_mm = 1e-6;

/// Circular arc or helix in the space of the three position joints (mm). p(phi) = center + r (cos phi u + sin
/// phi v) + lift f, phi from 0 to sweep_rad > 0. Here r = radius_mm and f = phi / sweep_rad unless the radii
/// at start and end disagree. Radius and lift otherwise change in proportion to the path length, f = s /
/// length (programs give centres in rounded numbers). This is a logarithmic spiral, the one spiral with a
/// known length in closed form.
struct Arc {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    Eigen::Vector3d u = Eigen::Vector3d::UnitX();  ///< Unit vector from the centre to the start.
    Eigen::Vector3d v = Eigen::Vector3d::UnitY();  ///< Unit vector of the direction of travel at the start.
    double radius_mm = 0;                          ///< At the start.
    double end_radius_mm = 0;  ///< Radius at the end; radius_mm within rounding in most programs.
    double sweep_rad = 0;      ///< Total angle, more than 2 pi for several turns.
    Eigen::Vector3d lift = Eigen::Vector3d::Zero();  ///< Travel along the axis over the full sweep (helix).

    double length_mm() const;
    /// Returns the angle at a distance of `s_mm` along the arc.
    double phi_at(double s_mm) const;
    /// Returns the distance along the arc up to an angle.
    double length_to(double phi_rad) const;
    /// Returns the part of the arc between two path lengths.
    Arc part(double from_mm, double to_mm) const;
    Eigen::Vector3d at(double phi_rad) const;
    /// Returns the unit tangent of the travel at phi.
    Eigen::Vector3d tangent(double phi_rad) const;
    /// Returns the second derivative of the point by path length at phi (1/mm): towards the centre, as long
    /// as the curvature.
    Eigen::Vector3d curvature(double phi_rad) const;
    /// Returns the largest curvature on the path, in 1/mm.
    double max_curvature() const;
    /// Returns the largest share of the path speed that coordinate `axis` (0, 1, 2) can have, over the full
    /// circle.
    double max_share(int axis) const;
    /// Returns max_share() of all three.
    Eigen::Vector3d max_shares() const;
    /// Returns quick bounds of coordinate `axis` (0, 1, 2), which may be too wide: those of the full circle.
    Range bounds(int axis) const;
    /// Returns a bound of how far a coordinate without lift exceeds its values at the two ends, in mm; tight
    /// if the sweep is small.
    double bulge_mm() const;
    /// Returns the lowest and highest value of coordinate `axis` (0, 1, 2) from phi 0 to sweep_rad.
    Range range(int axis) const;
};

}  // namespace gsim::motion
