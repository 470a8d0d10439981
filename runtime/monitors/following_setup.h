#pragma once

#include <Eigen/Core>
#include <vector>

#include "machine/model/machine.h"
#include "motion/planner/planner_setup.h"

namespace gsim::simulation {

/// Inputs for the computation of following errors. All of it outlives its user.
struct FollowingSetup {
    const machine::Machine& machine;
    const motion::PlannerSetup& planner;
    const std::vector<Eigen::Vector3d>& tcp_offsets_mm;  ///< Indexed by MoveInfo::tcp.
};

}  // namespace gsim::simulation
