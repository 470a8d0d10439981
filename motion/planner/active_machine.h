#pragma once

#include <memory>
#include <optional>

#include "motion/path/axis_space.h"
#include "motion/planner/move_parameters.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// Machine of a planner: as the planner was given it, and with the changes of the last move parameters.
class ActiveMachine {
  public:
    /// Throws std::invalid_argument with the message of setup.validate() if that finds an error.
    explicit ActiveMachine(PlannerSetup setup);
    ActiveMachine(const ActiveMachine&) = delete;
    ActiveMachine& operator=(const ActiveMachine&) = delete;

    /// Sets the operator's overrides, on the planner's clock. Call before the first move.
    void set_overrides(std::shared_ptr<const OverrideSchedule> overrides) {
        original_.overrides = setup_.overrides = std::move(overrides);
    }
    /// Sets the source of the joint accelerations for each move. Call before the first move.
    void set_move_limits(std::shared_ptr<const MoveLimits> limits) {
        original_.move_limits = setup_.move_limits = std::move(limits);
    }
    /// Activates what these parameters change of the machine, as a move with them does. setup() remains the
    /// same object.
    void use(const MoveParameters& move_parameters);
    /// Drops the changes of all move parameters.
    void restart();

    /// Returns the machine without the changes of move parameters.
    const PlannerSetup& original() const { return original_; }
    /// Returns the machine with the changes of the last move parameters.
    const PlannerSetup& setup() const { return setup_; }
    /// Returns the space of the position joints; null if they do not span one (AxisSpace::of()).
    const AxisSpace* axis_space() const { return axis_space_ ? &*axis_space_ : nullptr; }
    /// True if the inverse keeps some joints at their values.
    bool has_fixed_joints() const { return !setup_.kinematics->fixed_joints().empty(); }
    /// True if the joints of a move are coordinated with each other; a rapid may be without.
    bool is_interpolated(bool rapid) const {
        return setup_.controller.coordination.interpolated_rapids || !rapid;
    }

    /// Returns RRS_MODE_NOT_SUPPORTED if the controller has its own ramps.
    PlanResult check_ramps() const;
    /// Returns RRS_MODE_NOT_SUPPORTED if the machine does not have three slides that compensate for the TCP
    /// motion of its rotary joints.
    PlanResult check_tcp_control() const;

  private:
    PlannerSetup original_;
    PlannerSetup setup_;
    std::shared_ptr<const PlannerSetup> used_machine_;
    std::shared_ptr<const ProgrammedRamps> used_ramps_;
    std::optional<AxisSpace> axis_space_;
};

/// Returns how many slides carry the TCP along x, y or z of the axis space.
int slide_count(const PlannerSetup& setup);

}  // namespace gsim::motion
