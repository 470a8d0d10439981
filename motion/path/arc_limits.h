#pragma once

#include "motion/path/arc.h"
#include "motion/path/master_path.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// Lowers the limits along an arc so that the joints keep their jerks all round it, if the controller limits
/// jerks. A joint with the path p(s) over the path length s gets p' j + 3 p'' v a + p''' v^3. The second term
/// is across the path on a circle of curvature k, and the others are along it. Each has at most 1 / (1 + sqrt
/// 2) of the joint's jerk, so that their sum keeps it for any climb of the path along the joint. Must be
/// called once all other limits are in `master`.
void limit_by_arc_jerk(const PlannerSetup& setup, const Arc& arc, MasterPath& master);

/// Limits the acceleration along a helix for each joint that is askew to both its plane and its axis. The
/// path round takes up to `centripetal_share` of the joint's acceleration. The climb at worst adds fully to
/// the vector sum of both in the plane. Lowers nothing if each joint is in the plane or along the axis.
void limit_by_oblique_helix(const PlannerSetup& setup, const Arc& arc, double centripetal_share,
                            MasterPath& master);

}  // namespace gsim::motion
