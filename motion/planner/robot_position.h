#pragma once

#include "controller/services/types.h"

namespace gsim::motion {

/// Joint values at the last target of a planner, mm or rad; while a conveyor is tracked, in its frame.
class RobotPosition {
  public:
    /// Makes a position that is not set yet, for a machine with so many joints.
    explicit RobotPosition(int joint_count) : joints_(rrs::JointPos::Zero(joint_count)) {}

    /// Returns the values; 0 before they are set.
    const rrs::JointPos& joints() const { return joints_; }
    bool is_set() const { return is_set_; }
    /// Sets the position where the first move begins.
    void start_at(const rrs::JointPos& joints) {
        joints_ = joints;
        is_set_ = true;
    }
    /// Moves on to the next target. A position must be set.
    void move_to(const rrs::JointPos& joints) { joints_ = joints; }
    /// Returns to the state without a position.
    void restart() {
        joints_.setZero();
        is_set_ = false;
    }

  private:
    rrs::JointPos joints_;
    bool is_set_ = false;
};

}  // namespace gsim::motion
