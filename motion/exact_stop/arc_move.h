#pragma once

#include "motion/planner/move_rules.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

/// Returns RRS_INVALID_PARAMETER if the arc leaves the position joints that the machine has.
PlanResult check_arc(const PlannerSetup& setup, const Arc& arc);

/// Plans circular motion along segment.arc from segment.start to segment.end in the position joints. All
/// other moving joints follow, except those of segment.orientation, which move with the arc. Tangential speed
/// and acceleration keep the programmed values, the limits of the path and, for the direction of travel in
/// which each is worst, those of the position joints. Acceleration towards the centre is not limited here;
/// Segment::peak_centripetal_mm_s2 reports it. RRS_ZERO_SPEED and as check_arc().
PlanResult plan_arc(const PlannerSetup& setup, const MoveRules& rules, Segment& segment);

}  // namespace gsim::motion
