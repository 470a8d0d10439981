#pragma once

#include "machine/model/machine.h"
#include "motion/planner/planner_setup.h"

namespace gsim::simulation {

/// Returns the planner's data of a machine: X, Y and Z, if they are linear, carry the tool.
motion::PlannerSetup make_planner_setup(const machine::Machine& machine);

}  // namespace gsim::simulation
