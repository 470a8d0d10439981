#include "runtime/simulator/commands.h"

#include <cmath>

namespace gsim::simulation {

Eigen::Vector3d ArcMove::axis() const {
    return kind == MoveKind::arc_ccw ? normal : Eigen::Vector3d(-normal);
}

Eigen::Vector3d ArcMove::radius_to(const Eigen::Vector3d& point_mm) const {
    const Eigen::Vector3d from_center = point_mm - center_mm;
    return from_center - normal.dot(from_center) * normal;
}

double ArcMove::length_mm(const Eigen::Vector3d& start_mm, const Eigen::Vector3d& end_mm) const {
    return std::hypot(radius_to(start_mm).norm() * sweep_rad, normal.dot(end_mm - start_mm));
}

}  // namespace gsim::simulation
