#pragma once

#include <vector>

#include "controller/services/types.h"
#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// A place on a way of the joints.
struct WayPoint {
    rrs::JointPos position;  ///< mm or rad
    rrs::JointPos slope;     ///< Change of the joints by length of way.
};

/// A way whose accelerations are asked for.
struct WayToLimit {
    std::vector<WayPoint> points;  ///< In order, three at least.
    /// The joints go in proportion, by the slope of any point; else each may need what it has in either sense
    /// at any place.
    bool straight = false;
    bool rests = false;    ///< It begins and ends at rest; else it may be passed at any speed.
    double length = 0;     ///< mm or rad; 0: of a corner.
    double curvature = 0;  ///< The greatest, by that length.
    double max_speed = 0;  ///< That nothing but accelerations lowers; finite.
};

/// Sets the accelerations of the joints for single moves, where they are no constants of the machine.
class MoveLimits {
  public:
    virtual ~MoveLimits() = default;
    /// Sets the accelerations and decelerations in `joints` to what holds all along the way, at all speeds up
    /// to way.max_speed, which it may lower. RRS_INVALID_PARAMETER where none does.
    virtual Planned limit(WayToLimit& way, std::vector<JointSetup>& joints) const = 0;
};

}  // namespace gsim::motion
