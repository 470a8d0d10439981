#include "motion/linuxcnc/axes.h"

#include <algorithm>
#include <cmath>

#include "motion/path/axis_space.h"

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

Axes::Axes(const PlannerSetup& setup)
    : joints_(setup.position_joints),
      max_speed_mm_s_(Vector3d::Constant(kUnlimited)),
      max_acceleration_mm_s2_(Vector3d::Constant(kUnlimited)),
      max_jerk_mm_s3_(Vector3d::Constant(kUnlimited)) {
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = joints_[static_cast<std::size_t>(axis)];
        if (joint < 0) continue;
        const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
        max_speed_mm_s_[axis] = limits.max_speed;
        max_acceleration_mm_s2_[axis] = limits.max_acceleration;
        max_jerk_mm_s3_[axis] = limits.max_jerk;
    }
}

Vector3d Axes::point(const rrs::JointPos& joints) const {
    Vector3d point = Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = joints_[static_cast<std::size_t>(axis)];
        if (joint >= 0) point[axis] = joints[joint];
    }
    return point;
}

void Axes::set_point(const Vector3d& point, rrs::JointPos& joints) const {
    write_position(joints_, point, joints);
}

double Axes::in_plane(const Vector3d& limits, const Vector3d& normal) {
    double min = kUnlimited;
    for (int axis = 0; axis < 3; ++axis) {
        const double share = std::sqrt(std::max(0.0, 1 - normal[axis] * normal[axis]));
        if (share > 0) min = std::min(min, limits[axis] / share);
    }
    return min;
}

}  // namespace gsim::motion::linuxcnc
