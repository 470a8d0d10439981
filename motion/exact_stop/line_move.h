#pragma once

#include "motion/planner/move_rules.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

/// Plans a straight line from segment.start to segment.end. The position joints are masters if any of them
/// moves, in a straight line; else the other prismatic joints; else the rotary joints, in the space of their
/// angles. All other moving joints follow, except those of segment.orientation, which move with the master;
/// if rotary joints alone move, its angle is the master. A move without a change becomes a segment of no
/// duration. RRS_ZERO_SPEED, RRS_INVALID_PARAMETER.
PlanResult plan_line(const PlannerSetup& setup, const MoveRules& rules, Segment& segment);

/// Makes the segment a standstill of `duration_s`.
void plan_standstill(Segment& segment, double duration_s);

/// Returns the error of a path that needs a programmed speed and has none.
tl::unexpected<PlanError> no_programmed_speed_error();

}  // namespace gsim::motion
