#pragma once

#include <Eigen/Core>
#include <string>

#include <tl/expected.hpp>

#include "motion/planner/planner_setup.h"

namespace gsim::simulation {

/// Coordinates of the TCP under TCP control. X, Y and Z are the position of the TCP in the work, along the
/// slides in their direction while the rotary axes are at zero. The other coordinates are the axes. With
/// rotary axes at zero, and a tool of no length, the coordinates are the axes' own. If slides are not quite
/// square (calibrated machines), the coordinates are: X is along its slide, Y in the plane of both.
class TcpFrame {
  public:
    /// `zero`: the joints with all axes at 0. `tool_mm`: the machine's tool centre point, as the program has
    /// set it, relative to that of the kinematics. `offset_mm`: the tool length offset, with the other axes
    /// at zero. It is the travel of the slides x, y, z that brings the TCP of this tool to the position of
    /// the TCP without a tool. The error is a message.
    static tl::expected<TcpFrame, std::string> make(const motion::PlannerSetup& setup,
                                                    const rrs::JointPos& zero, const Eigen::Vector3d& tool_mm,
                                                    const Eigen::Vector3d& offset_mm);

    /// Returns the TCP in the frame of the kinematics' tool centre point.
    const Eigen::Vector3d& tcp_mm() const { return tcp_mm_; }
    /// Returns the joints at which x, y, z of `coordinates` are those of the TCP. The error is a message.
    tl::expected<rrs::JointPos, std::string> joints(const motion::PlannerSetup& setup,
                                                    const rrs::JointPos& coordinates) const;
    /// Returns the coordinates of the TCP at these joints.
    rrs::JointPos coordinates(const motion::PlannerSetup& setup, const rrs::JointPos& joints) const;
    /// Returns a point in the work frame by its x, y, z.
    Eigen::Vector3d point(const Eigen::Vector3d& coordinates_mm) const {
        return origin_mm_ + directions_ * coordinates_mm;
    }
    /// Returns the axis in the work frame about which a turn is counter-clockwise if it is so about `axis`
    /// here.
    Eigen::Vector3d turn_axis(const Eigen::Vector3d& axis) const {
        return handedness_ * (directions_ * axis);
    }

  private:
    Eigen::Matrix3d directions_ = Eigen::Matrix3d::Identity();  ///< Directions x, y, z; at right angles.
    Eigen::Vector3d origin_mm_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d tcp_mm_ = Eigen::Vector3d::Zero();
    double handedness_ = 1;
};

}  // namespace gsim::simulation
