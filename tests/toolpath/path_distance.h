#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>

#include "toolpath/model/arc_shape.h"

namespace gsim::path {

/// Returns the distance of a position from the line or arc from `start` to `end`, mm.
inline double off_the_way(const Eigen::Vector3d& position, const Eigen::Vector3d& start,
                          const Eigen::Vector3d& end, const std::optional<ArcShape>& arc) {
    if (!arc) {
        const Eigen::Vector3d displacement = end - start;
        const double share =
            displacement.norm() > 0
                ? std::clamp((position - start).dot(displacement) / displacement.squaredNorm(), 0.0, 1.0)
                : 0;
        return (start + share * displacement - position).norm();
    }
    const double height = arc->normal.dot(position - arc->center);
    const Eigen::Vector3d radius = position - arc->center - height * arc->normal;
    const double out_of_range =
        std::max({0.0, -height * (arc->rise_mm < 0 ? -1 : 1), std::abs(height) - std::abs(arc->rise_mm)});
    return std::hypot(radius.norm() - arc->radius_mm(), out_of_range);
}

}  // namespace gsim::path
