#pragma once

#include <array>

#include "controller/services/types.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// Change of each joint in a move (mm or rad, signed). A change of up to `min` does not count: it is
/// rounding of frames and inverse kinematics, not motion.
class JointChanges {
  public:
    JointChanges(const PlannerSetup& setup, const rrs::JointPos& start, const rrs::JointPos& end,
                 double min = 1e-9);

    double of(int joint) const { return changes_[static_cast<std::size_t>(joint)]; }
    JointRole role(int joint) const { return roles_[static_cast<std::size_t>(joint)]; }
    /// Returns the Euclidean norm of the changes of the joints of one role (mm or rad).
    double norm(JointRole role) const { return norms_[static_cast<std::size_t>(role)]; }

  private:
    std::array<double, rrs::kMaxJoints>
        changes_;  // only as many hold values as there are joints, like roles_
    std::array<JointRole, rrs::kMaxJoints> roles_;
    std::array<double, 3> norms_{};
};

}  // namespace gsim::motion
