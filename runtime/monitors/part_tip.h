#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/services/types.h"
#include "motion/planner/planner_setup.h"

namespace gsim::simulation {

/// Position of a tool's TCP on the part, that is in the machine's work frame, mm.
class PartTip {
  public:
    /// Sets the TCP. `tip_mm`: the tool tip as seen from the tool centre point of the kinematics, which
    /// `setup` keeps alive.
    PartTip(const motion::PlannerSetup& setup, const Eigen::Vector3d& tip_mm);

    /// Returns true if some joints turn the TCP about the part.
    bool ever_turns() const { return !turning_.empty(); }
    /// Returns true if X, Y and Z of the position joints are a point's on the part, in another frame:
    /// distances are the same.
    bool keeps_distances() const { return keeps_distances_; }
    /// Returns true if one of them has another value in `to` than in `from`.
    bool turns(const rrs::JointPos& from, const rrs::JointPos& to) const;
    /// Returns how far joints that turn the TCP move from `from` to `to`, all of them together.
    double turned_rad(const rrs::JointPos& from, const rrs::JointPos& to) const;
    /// Makes at() fast for all poses with the same values of the turning joints as here: there the TCP moves
    /// straight if the joints do.
    void stand_at(const rrs::JointPos& joints);
    Eigen::Vector3d at(const rrs::JointPos& joints) const;

  private:
    bool moved_by_position_alone(const motion::PlannerSetup& setup) const;

    const kinematics::Kinematics* kinematics_;
    Eigen::Vector3d tip_mm_;
    std::vector<int> turning_;  ///< Joints that turn the TCP about the part; empty if none moves it.
    bool keeps_distances_ = false;
    rrs::JointPos standing_;  ///< Joints at which the map holds; of size 0: none yet.
    Eigen::Vector3d origin_mm_ = Eigen::Vector3d::Zero();
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, rrs::kMaxJoints> slopes_;
};

}  // namespace gsim::simulation
