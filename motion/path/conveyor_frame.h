#pragma once

#include <Eigen/Core>

#include "motion/path/axis_space.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

/// Conveyor as a planner knows it: it travels along a line at constant speed.
struct ConveyorMotion {
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< Unit vector of the world.
    double speed_mm_s = 0;                                 ///< Negative: backwards.
    double position_mm = 0;                                ///< At at_s.
    double at_s = 0;

    double position_mm_at(double time_s) const { return position_mm + speed_mm_s * (time_s - at_s); }
};

/// Frame of a conveyor, in which targets are given while it is tracked. A motion in it becomes one of the
/// machine with the conveyor's own motion superimposed. So the joints have only the speed that the conveyor
/// leaves.
class ConveyorFrame {
  public:
    /// Returns the frame. Errors: RRS_MODE_NOT_SUPPORTED if no position joints carry the tool in all
    /// directions, RRS_JOINT_LIMIT if the conveyor is faster than a joint.
    static tl::expected<ConveyorFrame, PlanError> of(const PlannerSetup& setup, const AxisSpace* space,
                                                     const ConveyorMotion& conveyor);

    const ConveyorMotion& conveyor() const { return conveyor_; }
    /// Returns what the frame adds to joint values at a time.
    rrs::JointPos shift(double time_s) const;
    /// Returns the machine with the remainder of its speeds.
    PlannerSetup remaining_setup(const PlannerSetup& setup) const;
    /// Turns a segment planned in the frame into one of the machine.
    void superimpose(Segment& segment) const;
    /// Plans the shortest path of the joints from standstill to the conveyor's motion, or from there to
    /// standstill. The segment has its start already. Error: RRS_JOINT_LIMIT.
    PlanResult plan_ramp(const PlannerSetup& setup, bool up, Segment& segment) const;

  private:
    ConveyorFrame(const ConveyorMotion& conveyor, const rrs::JointPos& along)
        : conveyor_(conveyor), joints_per_mm_(along) {}

    ConveyorMotion conveyor_;
    rrs::JointPos joints_per_mm_;  ///< Change of joint values by a mm of travel.
};

}  // namespace gsim::motion
