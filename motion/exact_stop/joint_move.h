#pragma once

#include "motion/planner/move_parameters.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

/// Plans joint motion from segment.start to segment.end: all joints in proportion, by one law, with the
/// master joint at its limit, or at a share of its speed. A move without a change becomes a segment of no
/// duration. RRS_ZERO_SPEED, RRS_INVALID_PARAMETER.
PlanResult plan_joint_move(const PlannerSetup& setup, const MoveParameters& move_parameters,
                           double speed_share, Segment& segment);

}  // namespace gsim::motion
