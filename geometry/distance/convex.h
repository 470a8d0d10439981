#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>

namespace gsim::cell {

/// A convex body in its own frame: a core, and everything within `margin_mm` of it. The core is the hull of
/// up to three points (one for a sphere, two for a capsule), a box or a cylinder about the origin.
struct Convex {
    enum class Core : std::uint8_t { points, box, cylinder };

    Core core = Core::points;
    std::array<Eigen::Vector3d, 3> points{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                          Eigen::Vector3d::Zero()};
    int point_count = 1;
    /// Half the size of a box; for a cylinder about Z: the radius, the radius again, and half the height.
    Eigen::Vector3d half_mm = Eigen::Vector3d::Zero();
    double margin_mm = 0;

    /// Returns the point of the core that is farthest in a direction of any length.
    Eigen::Vector3d support(const Eigen::Vector3d& direction) const;
};

/// The hull of a body at two poses: the volume that it passes on a straight path between them, if it does not
/// turn.
struct SweptConvex {
    const Convex& body;
    const Eigen::Isometry3d& from;
    const Eigen::Isometry3d& to;

    Eigen::Vector3d support(const Eigen::Vector3d& direction) const;
};

/// The distance between two bodies, within bounds: lower_mm <= distance <= upper_mm, 0 if they overlap.
struct Gap {
    double lower_mm = 0;
    double upper_mm = 0;
    Eigen::Vector3d on_first = Eigen::Vector3d::Zero();   ///< The nearest point of the first body ...
    Eigen::Vector3d on_second = Eigen::Vector3d::Zero();  ///< ... and of the second.
};

/// Requested accuracy of a distance.
struct ShapeDistanceRequest {
    double cutoff_mm;               ///< A distance that is known to be as large need not be known better.
    double relative_tolerance = 0;  ///< Share of upper_mm by which lower_mm may fall short of it.
};

/// Returns the distance between a moving body and one at standstill, by the algorithm of Gilbert, Johnson and
/// Keerthi (IEEE J. Robotics and Automation 4, 1988). Unless less is requested, both bounds are 1e-9 mm from
/// each other. Rounding in flat sets of corners can leave some 1e-5 mm; both bounds remain valid.
Gap shape_distance(const SweptConvex& moving, const Convex& fixed, const Eigen::Isometry3d& fixed_pose,
                   const ShapeDistanceRequest& request);

}  // namespace gsim::cell
