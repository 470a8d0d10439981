#include "runtime/motion/axis_space.h"

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

}  // namespace gsim::motion
