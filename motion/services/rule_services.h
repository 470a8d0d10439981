#pragma once

#include "motion/planner/active_machine.h"
#include "motion/planner/plan_error.h"
#include "motion/services/selections.h"

namespace gsim::motion {

/// Services that change rules of the machine for the targets that follow: corners, exact stops and
/// orientation. Each function does the same as the service of its name. It requires Initialize.
class RuleServices {
  public:
    /// Makes the services of `selections` for a planner's machine; both must outlive them.
    RuleServices(ActiveMachine& machine, Selections& selections)
        : machine_(machine), selections_(selections) {}

    PlanResult select_flyby_criteria(int criterion);
    PlanResult set_flyby_criteria_parameter(int criterion, int joint, double value);
    PlanResult cancel_flyby_criteria(int criterion);
    PlanResult select_point_accuracy(int accuracy_type);
    PlanResult set_point_accuracy_parameter(int accuracy_type, double value);
    PlanResult select_orientation_interpolation_mode(int mode);

  private:
    PlanResult check_criterion(int criterion) const;
    PlanResult check_criterion_value(int criterion, int joint, double value) const;
    PlanResult check_accuracy(int accuracy_type) const;
    void set_corner_rule(rrs::CornerRule rule);
    template <typename Change>
    void change_machine(const Change& change);

    ActiveMachine& machine_;
    Selections& selections_;
};

}  // namespace gsim::motion
