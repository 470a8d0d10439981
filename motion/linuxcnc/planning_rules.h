#pragma once

#include "motion/planner/planner_setup.h"

namespace gsim::motion::linuxcnc {

/// Planning parameters of LinuxCNC's releases.
struct PlanningRules {
    double period_s = 1e-3;  ///< Period of the controller loop.
    /// True for release 2.10: sub-segments have their full acceleration except while two of them overlap, and
    /// arcs are slowed as soon as they are queued.
    bool since_2_10 = false;
    bool s_curves = false;          ///< Ramps keep jerk limits (planner 1 of 2.10).
    double path_jerk = kUnlimited;  ///< Jerk per sub-segment, and across arcs.
};

}  // namespace gsim::motion::linuxcnc
