#pragma once

#include "motion/path/arc.h"
#include "motion/path/lead_path.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// Lowers the limits along an arc so that the joints keep their jerks all round it, where the controller
/// limits jerks. By the length s of the way p(s) a joint gets p' j + 3 p'' v a + p''' v^3. On a circle of
/// curvature k the second is across the way and the others are along it; each has at most 1 / (1 + sqrt 2) of
/// the joint's jerk, so that their sum keeps it whatever part of the way climbs along the joint. To be called
/// when all other limits are in the lead.
void limit_by_arc_jerk(const PlannerSetup& setup, const Arc& arc, LeadPath& lead);

/// The most that a joint can accelerate along the way of a helix whose plane and axis it both lies askew to,
/// where the way round takes up to `centripetal_share` of its acceleration: at worst the climb adds wholly to
/// the vector sum of both in the plane. Lowers nothing where each joint lies in the plane or along the axis.
void limit_by_askew_climb(const PlannerSetup& setup, const Arc& arc, double centripetal_share,
                          LeadPath& lead);

}  // namespace gsim::motion
