#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "runtime/motion/planner_setup.h"

namespace gsim::motion {

/// The rigid map (it may mirror) from the world to the space of the three position joints, in which the tool
/// tip's coordinates are the joint values themselves.
class AxisSpace {
  public:
    /// Found from the machine's forward kinematics; nothing where there are not three position joints, or
    /// they do not carry the tip along three directions at right angles (to 1e-9).
    static std::optional<AxisSpace> of(const PlannerSetup& setup);

    Eigen::Vector3d point(const Eigen::Vector3d& world_mm) const {
        return to_axes_ * (world_mm - origin_mm_);
    }
    /// The axis about which a turn, counter-clockwise about `world` in the world, is counter-clockwise here.
    Eigen::Vector3d turn_axis(const Eigen::Vector3d& world) const { return handedness_ * (to_axes_ * world); }

  private:
    Eigen::Matrix3d to_axes_;
    Eigen::Vector3d origin_mm_;
    double handedness_ = 1;
};

/// Whether rotary joints move the tip, a point in the frame of the tool centre point, in the work frame, so
/// that lines of the joints are none of the tip.
bool tip_turns(const PlannerSetup& setup, const Eigen::Vector3d& tip_mm = Eigen::Vector3d::Zero());

/// The values of the position joints; 0 where one is absent.
inline Eigen::Vector3d position_of(const PlannerSetup& setup, const rrs::JointPos& joints) {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        if (joint >= 0) position[axis] = joints[joint];
    }
    return position;
}

/// Gives the position joints (-1: absent) the coordinates of a point or vector.
inline void put_position(const std::array<int, 3>& position_joints, const Eigen::Vector3d& point,
                         rrs::JointPos& joints) {
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = position_joints[static_cast<std::size_t>(axis)];
        if (joint >= 0) joints[joint] = point[axis];
    }
}

}  // namespace gsim::motion
