#pragma once

#include <Eigen/Core>
#include <string>

#include "base/error.h"
#include "toolpath/model/path.h"

namespace gsim::path {

inline Eigen::Vector3d to_eigen(const Vector& vector) {
    return {vector[0], vector[1], vector[2]};
}

/// Max distance of the end of an arc about a centre from its circle, mm.
inline constexpr double kArcTolerance_mm = 0.01;

/// Circle or helix from one point to the next.
struct ArcShape {
    Eigen::Vector3d center;  ///< In the plane of the start.
    Eigen::Vector3d normal;  ///< Unit; the arc runs about it by the right hand.
    Eigen::Vector3d first;   ///< From the centre to the start.
    double end_radius_mm = 0;
    double turn_rad = 0;  ///< > 0
    double rise_mm = 0;   ///< Along the normal, over the full turn.

    double radius_mm() const;
    /// Returns the tool position at that share, 0 to 1, of the turn.
    Eigen::Vector3d at(double share) const;
};

/// Returns the arc of a circular motion from `start_mm` to a point.
Result<ArcShape> arc_shape(const Vector& start_mm, const Point& end);

}  // namespace gsim::path
