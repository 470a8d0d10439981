#pragma once

#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

// Values beyond a range give RRS_JOINT_LIMIT, or no error if the setup's OvertravelLog let them pass and note
// them.

/// Checks that joint values are in the joint ranges; 1e-9 mm or rad beyond counts as rounding.
PlanResult check_target_ranges(const PlannerSetup& setup, const rrs::JointPos& joints);

/// Checks that the position joints stay in their ranges all along an arc.
PlanResult check_arc_ranges(const PlannerSetup& setup, const Arc& arc);

/// Checks that the tilting joint stays in its range all along an orientation arc.
PlanResult check_tilt_range(const PlannerSetup& setup, const OrientationArc& arc);

/// Checks that all joints stay in their ranges on the path of a segment with a superimposed motion.
PlanResult check_path_ranges(const PlannerSetup& setup, const Segment& segment);

}  // namespace gsim::motion
