#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// The rigid map (it may mirror) from the world to the space of the three position joints, in which the tool
/// tip's coordinates are the joint values themselves.
class AxisSpace {
  public:
    /// Found from the machine's forward kinematics; nothing where there are not three position joints, or
    /// they do not carry the tip along three directions at right angles (to 1e-9).
    static std::optional<AxisSpace> of(const PlannerSetup& setup);

    Eigen::Vector3d point(const Eigen::Vector3d& world_mm) const;
    /// The axis about which a turn, counter-clockwise about `world` in the world, is counter-clockwise here.
    Eigen::Vector3d turn_axis(const Eigen::Vector3d& world) const;

  private:
    Eigen::Matrix3d to_axes_;
    Eigen::Vector3d origin_mm_;
    double handedness_ = 1;
};

/// Whether rotary joints move the tip, a point in the frame of the tool centre point, in the work frame, so
/// that lines of the joints are none of the tip.
bool tip_turns(const PlannerSetup& setup, const Eigen::Vector3d& tip_mm = Eigen::Vector3d::Zero());

/// The values of the position joints; 0 where one is absent.
Eigen::Vector3d position_of(const PlannerSetup& setup, const rrs::JointPos& joints);

/// Gives the position joints (-1: absent) the coordinates of a point or vector.
void put_position(const std::array<int, 3>& position_joints, const Eigen::Vector3d& point,
                  rrs::JointPos& joints);

}  // namespace gsim::motion
