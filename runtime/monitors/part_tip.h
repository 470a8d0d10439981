#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/services/types.h"
#include "motion/planner/planner_setup.h"

namespace gsim::simulation {

/// Where the tip of a tool is on the part, that is in the machine's work frame, mm.
class PartTip {
  public:
    /// `tip_mm`: the tip as seen from the tool centre point of the kinematics, which `setup` keeps alive.
    PartTip(const motion::PlannerSetup& setup, const Eigen::Vector3d& tip_mm);

    /// Whether there are joints that turn the tip about the part.
    bool ever_turns() const { return !turning_.empty(); }
    /// Whether X, Y and Z of the position joints are a point's on the part, seen another way: distances are
    /// the same.
    bool keeps_distances() const { return keeps_distances_; }
    /// Whether one of them has another value here than there.
    bool turns(const rrs::JointPos& from, const rrs::JointPos& to) const;
    /// How far joints that turn the tip go from here to there, all of them together.
    double turned_rad(const rrs::JointPos& from, const rrs::JointPos& to) const;
    /// From now on at() is fast wherever the joints that turn stand as they do here: there the tip goes
    /// straight where the joints do.
    void stand_at(const rrs::JointPos& joints);
    Eigen::Vector3d at(const rrs::JointPos& joints) const;

  private:
    bool moved_by_position_alone(const motion::PlannerSetup& setup) const;

    const kinematics::Kinematics* kinematics_;
    Eigen::Vector3d tip_mm_;
    std::vector<int> turning_;  ///< Joints that turn the tip about the part; none where none moves it.
    bool keeps_distances_ = false;
    rrs::JointPos standing_;  ///< The joints at which the map holds; of size 0: none yet.
    Eigen::Vector3d origin_mm_ = Eigen::Vector3d::Zero();
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, rrs::kMaxJoints> slopes_;
};

}  // namespace gsim::simulation
