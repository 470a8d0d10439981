#pragma once

#include <Eigen/Core>

namespace gsim::motion {

/// The lowest and highest value of something on the way.
struct Range {
    double min = 0;
    double max = 0;
};

/// What rounding may leave between the bounds of an arc and its points.
inline constexpr double kArcRounding_mm = 1e-6;

/// A circular arc or helix in the space of the three position joints (mm).
/// p(phi) = center + r (cos phi u + sin phi v) + lift f, phi from 0 to sweep_rad > 0, where r = radius_mm and
/// f = phi / sweep_rad unless the radii at start and end disagree. Where they do (programs give centres in
/// rounded numbers), radius and lift change in proportion to the length of path, f = s / length: a
/// logarithmic spiral, the one spiral whose length is known in closed form.
struct Arc {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    Eigen::Vector3d u = Eigen::Vector3d::UnitX();  ///< Unit vector from the centre to the start.
    Eigen::Vector3d v = Eigen::Vector3d::UnitY();  ///< Unit vector of the direction of travel at the start.
    double radius_mm = 0;                          ///< At the start.
    double end_radius_mm = 0;  ///< At the end; as radius_mm within rounding in most programs.
    double sweep_rad = 0;      ///< Total angle, more than 2 pi for several turns.
    Eigen::Vector3d lift = Eigen::Vector3d::Zero();  ///< Travel along the axis over the whole sweep (helix).

    double length_mm() const;
    /// The angle after a way of `s_mm` along the arc.
    double phi_at(double s_mm) const;
    /// The way along the arc up to an angle.
    double length_to(double phi_rad) const;
    /// The part of the arc between two lengths of way.
    Arc part(double from_mm, double to_mm) const;
    Eigen::Vector3d at(double phi_rad) const;
    /// Unit tangent of the travel at phi.
    Eigen::Vector3d tangent(double phi_rad) const;
    /// Second derivative of the point by the length of path at phi (1/mm): towards the centre, as long as the
    /// curvature.
    Eigen::Vector3d curvature(double phi_rad) const;
    /// The greatest curvature on the way, in 1/mm.
    double max_curvature() const;
    /// The greatest share of the path's speed that coordinate `axis` (0, 1, 2) can have, over the whole
    /// circle.
    double max_share(int axis) const;
    /// max_share() of all three.
    Eigen::Vector3d max_shares() const;
    /// Quick bounds of coordinate `axis` (0, 1, 2), which may be too wide: those of the whole circle.
    Range bounds(int axis) const;
    /// A bound of how far a coordinate without lift goes beyond its values at the two ends, in mm; tight
    /// where the sweep is small.
    double bulge_mm() const;
    /// Lowest and highest value of coordinate `axis` (0, 1, 2) from phi 0 to sweep_rad.
    Range range(int axis) const;
};

}  // namespace gsim::motion
