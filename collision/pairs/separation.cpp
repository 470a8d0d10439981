#include "collision/pairs/separation.h"

#include <algorithm>
#include <cmath>

namespace gsim::cell {

using Eigen::Vector3d;

namespace {

/// Returns the largest coordinate of a body along a direction.
double extent_mm(const Body& body, const LinkFrames& links, const Vector3d& direction) {
    const Eigen::Isometry3d pose = body.in_world(links);
    const Vector3d own = pose.linear().transpose() * direction;
    if (const Convex* convex = body.shape->convex())
        return direction.dot(pose * convex->support(own)) + convex->margin_mm;
    return direction.dot(pose * body.shape->middle_mm()) + own.cwiseAbs().dot(body.shape->half_mm());
}

}  // namespace

double gap_along_mm(const Body& first, const Body& second, const LinkFrames& links,
                    const Vector3d& direction) {
    return -extent_mm(first, links, -direction) - extent_mm(second, links, direction);
}

std::vector<double> ways_along_mm(const Ball& body, const JointPart& part, std::span<const int> between,
                                  const Vector3d& direction) {
    const auto axis_of = [&](int joint) -> const JointAxis& {
        return part.axes[static_cast<std::size_t>(joint)];
    };
    double turns_behind_rad = 0;  // of the joints after the current one, which turn its motion
    for (const int joint : between) {
        if (axis_of(joint).kind == rrs::JointKind::revolute) turns_behind_rad += part.half[joint];
    }
    double radius_mm = body.radius_mm;  // of a ball that the body stays in, whatever the joints so far do
    std::vector<double> ways_mm;
    ways_mm.reserve(between.size());
    for (const int joint : between) {
        const JointAxis& axis = axis_of(joint);
        const double half = part.half[joint];
        double whole_mm = half;
        double share = std::abs(axis.direction.dot(direction)) + turns_behind_rad;
        if (axis.kind == rrs::JointKind::revolute) {
            turns_behind_rad -= half;
            const Vector3d arm = body.middle_mm - axis.point_mm;
            const Vector3d lever = direction.cross(axis.direction);
            const double reach_mm = axis.direction.cross(arm).norm() + radius_mm;
            whole_mm = half * reach_mm;
            share =
                (std::abs(lever.dot(arm)) + lever.norm() * radius_mm) / reach_mm + half + turns_behind_rad;
        }
        ways_mm.push_back(whole_mm * std::min(1.0, share));
        radius_mm += whole_mm;
    }
    return ways_mm;
}

}  // namespace gsim::cell
