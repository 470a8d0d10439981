#pragma once

#include <Eigen/Core>
#include <vector>

#include "machine/model/machine.h"
#include "motion/planner/planner_setup.h"

namespace gsim::simulation {

/// What following errors are worked out from. All of it outlives whoever has it.
struct FollowingSetup {
    const machine::Machine& machine;
    const motion::PlannerSetup& planner;
    const std::vector<Eigen::Vector3d>& tips_mm;  ///< That MoveInfo::tip counts.
};

}  // namespace gsim::simulation
