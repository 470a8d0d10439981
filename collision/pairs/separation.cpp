#include "collision/pairs/separation.h"

#include <algorithm>
#include <cmath>

namespace gsim::cell {

using Eigen::Vector3d;

namespace {

/// Returns the largest coordinate of a body along a direction.
double extent_mm(const Body& body, const LinkFrames& links, const Vector3d& direction) {
    const Eigen::Isometry3d pose = body.pose_in_world(links);
    const Vector3d local = pose.linear().transpose() * direction;
    if (const Convex* convex = body.shape->convex())
        return direction.dot(pose * convex->support(local)) + convex->margin_mm;
    return direction.dot(pose * body.shape->middle_mm()) + local.cwiseAbs().dot(body.shape->half_mm());
}

}  // namespace

double distance_along_mm(const Body& first, const Body& second, const LinkFrames& links,
                         const Vector3d& direction) {
    return -extent_mm(first, links, -direction) - extent_mm(second, links, direction);
}

std::vector<double> travels_along_mm(const BoundingSphere& body, const JointPart& part,
                                     std::span<const int> between, const Vector3d& direction) {
    const auto joint_axis = [&](int joint) -> const JointAxis& {
        return part.axes[static_cast<std::size_t>(joint)];
    };
    double later_rotation_rad = 0;  // of the joints that follow the current one, which turn its motion
    for (const int joint : between) {
        if (joint_axis(joint).kind == rrs::JointKind::revolute) later_rotation_rad += part.half[joint];
    }
    double radius_mm = body.radius_mm;  // of a ball that the body stays in, whatever the joints so far do
    std::vector<double> travels_mm;
    travels_mm.reserve(between.size());
    for (const int joint : between) {
        const JointAxis& axis = joint_axis(joint);
        const double half = part.half[joint];
        double full_travel_mm = half;
        double share = std::abs(axis.direction.dot(direction)) + later_rotation_rad;
        if (axis.kind == rrs::JointKind::revolute) {
            later_rotation_rad -= half;
            const Vector3d arm = body.middle_mm - axis.point_mm;
            const Vector3d lever = direction.cross(axis.direction);
            const double reach_mm = axis.direction.cross(arm).norm() + radius_mm;
            full_travel_mm = half * reach_mm;
            share =
                (std::abs(lever.dot(arm)) + lever.norm() * radius_mm) / reach_mm + half + later_rotation_rad;
        }
        travels_mm.push_back(full_travel_mm * std::min(1.0, share));
        radius_mm += full_travel_mm;
    }
    return travels_mm;
}

}  // namespace gsim::cell
