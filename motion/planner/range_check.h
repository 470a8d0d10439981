#pragma once

#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

// What lies beyond a range is RRS_JOINT_LIMIT; or else nothing, where the setup's RangeNotes let it pass and
// note it.

/// Whether joint values lie in the joints' ranges; 1e-9 mm or rad beyond counts as rounding.
Planned check_target_ranges(const PlannerSetup& setup, const rrs::JointPos& joints);

/// Whether the position joints stay in their ranges all along an arc.
Planned check_arc_ranges(const PlannerSetup& setup, const Arc& arc);

/// Whether the tilting joint stays in its range all along an orientation arc.
Planned check_tilt_range(const PlannerSetup& setup, const OrientationArc& arc);

/// Whether all joints stay in their ranges on the way of a segment with a motion beside it.
Planned check_way_ranges(const PlannerSetup& setup, const Segment& segment);

}  // namespace gsim::motion
