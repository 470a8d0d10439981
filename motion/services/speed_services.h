#pragma once

#include <span>
#include <string_view>

#include "motion/planner/active_machine.h"
#include "motion/planner/plan_error.h"
#include "motion/services/selections.h"

namespace gsim::motion {

/// Services that set speeds, accelerations and ramps for the targets that follow. Each service function does
/// the same as the service of its name. It requires Initialize.
class SpeedServices {
  public:
    /// Makes the services of `selections` for a planner's machine; both must outlive them.
    SpeedServices(ActiveMachine& machine, Selections& selections)
        : machine_(machine), selections_(selections) {}

    PlanResult set_joint_speeds(std::span<const int> joints, std::span<const double> speeds);
    PlanResult set_joint_accelerations(std::span<const int> joints, std::span<const double> accelerations);
    PlanResult set_joint_jerks(std::span<const int> joints, std::span<const double> jerks);
    PlanResult set_ramp_mode(rrs::RampMode mode);
    PlanResult set_joint_ramp_limits(rrs::RampLimit limit, std::span<const int> joints,
                                     std::span<const double> values);

    PlanResult set_cartesian_position_speed(double speed_mm_s);
    PlanResult set_cartesian_orientation_speed(double speed_rad_s);
    PlanResult set_cartesian_position_acceleration(double acceleration_mm_s2);
    PlanResult set_cartesian_orientation_acceleration(double acceleration_rad_s2);
    PlanResult set_override_speed(double percent);
    PlanResult set_override_acceleration(double percent);

  private:
    PlanResult set_joint_values(rrs::JointPos& values, std::span<const int> joints,
                                std::span<const double> requested, std::string_view what) const;
    PlanResult set_joint_parameters(rrs::JointPos JointParameters::*values, std::span<const int> joints,
                                    std::span<const double> requested, std::string_view what);
    ProgrammedRamps ramps() const;
    void set_ramps(const ProgrammedRamps& ramps);

    ActiveMachine& machine_;
    Selections& selections_;
};

}  // namespace gsim::motion
