#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/services/types.h"
#include "motion/planner/planner_setup.h"

namespace gsim::simulation {

/// Position of a tool's TCP on the part, that is in the machine's work frame, mm.
class WorkpieceTcp {
  public:
    /// Sets the TCP. `tcp_mm`: the tool tip as seen from the tool centre point of the kinematics, which
    /// `setup` keeps alive.
    WorkpieceTcp(const motion::PlannerSetup& setup, const Eigen::Vector3d& tcp_mm);

    /// Returns true if some joints turn the TCP about the part.
    bool can_rotate() const { return !rotating_joints_.empty(); }
    /// Returns true if X, Y and Z of the position joints are a point's on the part, in another frame:
    /// distances are the same.
    bool preserves_distances() const { return preserves_distances_; }
    /// Returns true if one of them has another value in `to` than in `from`.
    bool turns(const rrs::JointPos& from, const rrs::JointPos& to) const;
    /// Returns how far joints that turn the TCP move from `from` to `to`, all of them together.
    double rotation_rad(const rrs::JointPos& from, const rrs::JointPos& to) const;
    /// Makes at() fast for all poses with the same values of the turning joints as here: there the TCP moves
    /// straight if the joints do.
    void set_position(const rrs::JointPos& joints);
    Eigen::Vector3d at(const rrs::JointPos& joints) const;

  private:
    bool moved_by_position_joints_only(const motion::PlannerSetup& setup) const;

    const kinematics::Kinematics* kinematics_;
    Eigen::Vector3d tcp_mm_;
    std::vector<int> rotating_joints_;  ///< Joints that turn the TCP about the part; empty if none moves it.
    bool preserves_distances_ = false;
    rrs::JointPos linearized_at_;  ///< Joints at which the map holds; of size 0: none yet.
    Eigen::Vector3d origin_mm_ = Eigen::Vector3d::Zero();
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, rrs::kMaxJoints> jacobian_;
};

}  // namespace gsim::simulation
