#pragma once

#include <Eigen/Core>

#include "motion/path/arc.h"
#include "motion/planner/plan_error.h"

namespace gsim::motion {

/// The arc from `start` to `end`, counter-clockwise by `sweep_rad` about the axis through `center` (any point
/// of it) along the unit vector `axis`; a helix where start and end differ along the axis. It starts and ends
/// exactly there: where the radii differ the arc is a spiral (see Arc), where the end lies off the end of the
/// sweep the sweep is adjusted, both by `tolerance_mm`, or half of the radius if that is less, at most.
/// RRS_CIRCLE_IMPOSSIBLE, RRS_INVALID_PARAMETER.
Planned arc_about(const Eigen::Vector3d& start, const Eigen::Vector3d& end, const Eigen::Vector3d& center,
                  const Eigen::Vector3d& axis, double sweep_rad, double tolerance_mm, Arc& arc);

/// The arc from `start` through `via` to `end`. RRS_CIRCLE_IMPOSSIBLE where two of the points coincide or
/// they lie on one line: via nearer to the chord than 1e-9 mm, or a radius of more than 1e9 mm.
Planned arc_through(const Eigen::Vector3d& start, const Eigen::Vector3d& via, const Eigen::Vector3d& end,
                    Arc& arc);

}  // namespace gsim::motion
