#pragma once

#include <vector>

#include "controller/services/types.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// Position on a joint path.
struct PathPoint {
    rrs::JointPos position;  ///< mm or rad
    rrs::JointPos slope;     ///< Change of the joints per path length.
};

/// Path for which accelerations are requested.
struct LimitedPath {
    std::vector<PathPoint> points;  ///< In order, three at least.
    /// True if the joints move in proportion, by the slope of any point. Otherwise each may need what it has
    /// in either direction at any position.
    bool straight = false;
    bool is_rest_to_rest = false;  ///< True if it begins and ends at standstill; else any speed may occur.
    double length = 0;             ///< mm or rad; 0: of a corner.
    double curvature = 0;          ///< The greatest, by that length.
    double max_speed = 0;          ///< Speed that only accelerations lower; finite.
};

/// Source of the joint accelerations for single moves, if they are no constants of the machine.
class MoveLimits {
  public:
    virtual ~MoveLimits() = default;
    /// Sets the accelerations and decelerations in `joints` to values that hold all along the path, at all
    /// speeds up to path.max_speed, which it may lower. Error: RRS_INVALID_PARAMETER if no values do.
    virtual PlanResult limit(LimitedPath& path, std::vector<JointSetup>& joints) const = 0;
};

}  // namespace gsim::motion
