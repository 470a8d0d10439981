#pragma once

#include "motion/moves/target_solver.h"
#include "motion/planner/active_machine.h"
#include "motion/services/selections.h"

namespace gsim::motion {

/// Services that compute poses and joint values. Each does the same as the service of its name. It requires
/// Initialize.
class KinematicsServices {
  public:
    /// Makes the services of a planner's machine for clients with `selections`. All must outlive them.
    KinematicsServices(const ActiveMachine& machine, const TargetSolver& targets,
                       const Selections& selections)
        : machine_(machine), targets_(targets), selections_(selections) {}

    PlanResult get_inverse_kinematics(const rrs::CartPos& pose, const rrs::JointPos& near,
                                      rrs::JointPos& joints) const;
    PlanResult get_forward_kinematics(const rrs::JointPos& joints, rrs::CartPos& pose) const;

  private:
    const ActiveMachine& machine_;
    const TargetSolver& targets_;
    const Selections& selections_;
};

}  // namespace gsim::motion
