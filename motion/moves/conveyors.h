#pragma once

#include <Eigen/Core>
#include <map>

#include "motion/moves/buffered_moves.h"
#include "motion/moves/motion_stop.h"
#include "motion/moves/tracked_frame.h"
#include "motion/planner/active_machine.h"
#include "motion/planner/robot_position.h"
#include "motion/planner/timeline.h"

namespace gsim::motion {

/// Conveyors that a client has defined, and the tracking of one of them. Each function does the same as the
/// service of its name.
class Conveyors {
  public:
    /// Makes one without conveyors. The references must outlive it.
    Conveyors(const ActiveMachine& machine, const MotionStop& motion_stop, TrackedFrame& tracked_frame,
              BufferedMoves& buffered_moves, Timeline& timeline, RobotPosition& position)
        : machine_(machine),
          motion_stop_(motion_stop),
          tracked_frame_(tracked_frame),
          buffered_moves_(buffered_moves),
          timeline_(timeline),
          position_(position) {}

    /// Defines a conveyor; `direction` is in the machine's own frame. Error: RRS_INVALID_PARAMETER.
    PlanResult define(int conveyor, const Eigen::Vector3d& direction, double speed_mm_s);
    /// Sets the position of a conveyor at the end of the timeline. Error: RRS_INVALID_PARAMETER.
    PlanResult set_position(int conveyor, double position_mm);
    /// Selects tracking. `base` is the turn of the machine in the world relative to its kinematics. Errors:
    /// RRS_INVALID_PARAMETER, RRS_MODE_NOT_SUPPORTED, RRS_JOINT_LIMIT.
    PlanResult select_tracking(int conveyor, bool on, const Eigen::Matrix3d& base);
    /// Returns to the state without conveyors.
    void restart() { conveyors_.clear(); }

  private:
    PlanResult start_tracking(int conveyor, ConveyorMotion motion, const Eigen::Matrix3d& base);
    PlanResult stop_tracking();

    const ActiveMachine& machine_;
    const MotionStop& motion_stop_;
    TrackedFrame& tracked_frame_;
    BufferedMoves& buffered_moves_;
    Timeline& timeline_;
    RobotPosition& position_;
    std::map<int, ConveyorMotion> conveyors_;
};

}  // namespace gsim::motion
