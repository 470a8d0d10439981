#pragma once

#include <Eigen/Core>
#include <string>

#include <tl/expected.hpp>

#include "motion/planner/planner_setup.h"

namespace gsim::simulation {

/// Coordinates of the tip under tool-centre-point control: X, Y and Z are where the tip is, in the work,
/// along the slides as they stand there while the rotary axes are at zero; the other axes are axes. With
/// these at zero, and a tool of no length, the coordinates are the axes' own. Where slides are not quite
/// square (calibrated machines) the coordinates are: X is along its slide, Y in the plane of both.
class TipFrame {
  public:
    /// `zero`: the joints with all axes at 0. `tool_mm`: the machine's tool centre point, as the program has
    /// set it, seen from that of the kinematics. `offset_mm`: how far the slides x, y, z have to go for the
    /// tip of this tool to stand, with the other axes at zero, where that of none would (tool length offset).
    /// The error is a sentence.
    static tl::expected<TipFrame, std::string> make(const motion::PlannerSetup& setup,
                                                    const rrs::JointPos& zero, const Eigen::Vector3d& tool_mm,
                                                    const Eigen::Vector3d& offset_mm);

    /// The tip in the frame of the tool centre point.
    const Eigen::Vector3d& tip_mm() const { return tip_mm_; }
    /// The joints where x, y, z of `coordinates` are the tip's. The error is a sentence.
    tl::expected<rrs::JointPos, std::string> joints(const motion::PlannerSetup& setup,
                                                    const rrs::JointPos& coordinates) const;
    /// The way back.
    rrs::JointPos coordinates(const motion::PlannerSetup& setup, const rrs::JointPos& joints) const;
    /// A point by its x, y, z in the work frame.
    Eigen::Vector3d point(const Eigen::Vector3d& coordinates_mm) const {
        return origin_mm_ + directions_ * coordinates_mm;
    }
    /// The axis in the work frame about which a turn is counter-clockwise that is so about `axis` here.
    Eigen::Vector3d turn_axis(const Eigen::Vector3d& axis) const {
        return handedness_ * (directions_ * axis);
    }

  private:
    Eigen::Matrix3d directions_ = Eigen::Matrix3d::Identity();  ///< Of x, y, z; at right angles.
    Eigen::Vector3d origin_mm_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d tip_mm_ = Eigen::Vector3d::Zero();
    double handedness_ = 1;
};

}  // namespace gsim::simulation
