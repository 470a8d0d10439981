#pragma once

#include <Eigen/Core>

#include "motion/path/arc.h"
#include "motion/planner/plan_error.h"

namespace gsim::motion {

/// Makes the arc from `start` to `end`, counter-clockwise by `sweep_rad` about the axis through `center` (any
/// point of it) along the unit vector `axis`. The arc is a helix if start and end differ along the axis. It
/// starts and ends exactly there. It is a spiral if the radii differ (see Arc), and its sweep is adjusted if
/// the end is off the end of the sweep. Both are allowed by `tolerance_mm`, or half of the radius if that is
/// less, at most. Errors: RRS_CIRCLE_IMPOSSIBLE, RRS_INVALID_PARAMETER.
PlanResult arc_about(const Eigen::Vector3d& start, const Eigen::Vector3d& end, const Eigen::Vector3d& center,
                     const Eigen::Vector3d& axis, double sweep_rad, double tolerance_mm, Arc& arc);

/// Makes the arc from `start` through `via` to `end`. Error: RRS_CIRCLE_IMPOSSIBLE if two of the points
/// coincide or they are on one line: via nearer to the chord than 1e-9 mm, or a radius of more than 1e9 mm.
PlanResult arc_through(const Eigen::Vector3d& start, const Eigen::Vector3d& via, const Eigen::Vector3d& end,
                       Arc& arc);

}  // namespace gsim::motion
