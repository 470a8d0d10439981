#include "motion/path/axis_space.h"

#include <Eigen/LU>

namespace gsim::motion {

std::optional<AxisSpace> AxisSpace::of(const PlannerSetup& setup) {
    rrs::JointPos joints = rrs::JointPos::Zero(setup.joint_count());
    AxisSpace space;
    space.origin_mm_ = setup.kinematics->forward(joints).translation();
    Eigen::Matrix3d directions;
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        if (joint < 0) return std::nullopt;
        joints.setZero();
        joints[joint] = 1;
        directions.col(axis) = setup.kinematics->forward(joints).translation() - space.origin_mm_;
    }
    space.to_axes_ = directions.transpose();
    if (!(space.to_axes_ * directions).isIdentity(1e-9)) return std::nullopt;
    space.handedness_ = directions.determinant() < 0 ? -1 : 1;
    return space;
}

bool rotary_joints_move_tcp(const PlannerSetup& setup, const Eigen::Vector3d& tcp_mm) {
    constexpr double kMotionTolerance_mm = 1e-7;
    rrs::JointPos joints = rrs::JointPos::Zero(setup.joint_count());
    for (int configuration = 0; configuration < 3; ++configuration) {
        const Eigen::Vector3d tcp = setup.kinematics->forward(joints) * tcp_mm;
        for (int joint = 0; joint < setup.joint_count(); ++joint) {
            if (setup.role(joint) != JointRole::rotary) continue;
            rrs::JointPos rotated = joints;
            rotated[joint] += 1;
            if ((setup.kinematics->forward(rotated) * tcp_mm - tcp).norm() > kMotionTolerance_mm) return true;
        }
        for (int joint = 0; joint < setup.joint_count(); ++joint)  // elsewhere, with no axes in line
            joints[joint] += setup.role(joint) == JointRole::rotary ? 0.5 + 0.1 * joint : 100.0 + 10 * joint;
    }
    return false;
}

Eigen::Vector3d AxisSpace::point(const Eigen::Vector3d& world_mm) const {
    return to_axes_ * (world_mm - origin_mm_);
}

Eigen::Vector3d AxisSpace::turn_axis(const Eigen::Vector3d& world) const {
    return handedness_ * (to_axes_ * world);
}

Eigen::Vector3d read_position(const PlannerSetup& setup, const rrs::JointPos& joints) {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        if (joint >= 0) position[axis] = joints[joint];
    }
    return position;
}

void write_position(const std::array<int, 3>& position_joints, const Eigen::Vector3d& point,
                    rrs::JointPos& joints) {
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = position_joints[static_cast<std::size_t>(axis)];
        if (joint >= 0) joints[joint] = point[axis];
    }
}

}  // namespace gsim::motion
