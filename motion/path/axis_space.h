#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// Rigid map (it may mirror) from the world to the space of the three position joints, in which the TCP
/// coordinates are the joint values themselves.
class AxisSpace {
  public:
    /// Returns the map found from the machine's forward kinematics. Returns nullopt without three position
    /// joints, or if they do not carry the TCP along three directions at right angles (to 1e-9).
    static std::optional<AxisSpace> of(const PlannerSetup& setup);

    Eigen::Vector3d point(const Eigen::Vector3d& world_mm) const;
    /// Returns the axis about which a turn is counter-clockwise here that is counter-clockwise about `world`
    /// in the world.
    Eigen::Vector3d turn_axis(const Eigen::Vector3d& world) const;

  private:
    Eigen::Matrix3d to_axes_;
    Eigen::Vector3d origin_mm_;
    double handedness_ = 1;
};

/// True if rotary joints move the controlled point in the work frame, so that lines of the joints are no
/// lines of this point. `tcp_mm` is the point in the frame of the tool centre point.
bool rotary_joints_move_tcp(const PlannerSetup& setup,
                            const Eigen::Vector3d& tcp_mm = Eigen::Vector3d::Zero());

/// Returns the values of the position joints; 0 if one is absent.
Eigen::Vector3d read_position(const PlannerSetup& setup, const rrs::JointPos& joints);

/// Sets the position joints (-1: absent) to the coordinates of a point or vector.
void write_position(const std::array<int, 3>& position_joints, const Eigen::Vector3d& point,
                    rrs::JointPos& joints);

}  // namespace gsim::motion
