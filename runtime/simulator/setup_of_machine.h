#pragma once

#include "machine/model/machine.h"
#include "motion/planner/planner_setup.h"

namespace gsim::simulation {

/// What the planner must know of a machine: X, Y and Z, where they are linear, carry the tool.
motion::PlannerSetup setup_of_machine(const machine::Machine& machine);

}  // namespace gsim::simulation
