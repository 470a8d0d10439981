#pragma once

#include "motion/planner/planner_setup.h"

namespace gsim::motion::linuxcnc {

/// What the planners of LinuxCNC's releases plan by.
struct Planning {
    double period_s = 1e-3;  ///< Of the controller's loop.
    /// As release 2.10 does: pieces have their whole acceleration but while two of them overlap, and arcs are
    /// slowed as soon as they are queued.
    bool since_2_10 = false;
    bool s_curves = false;          ///< Ramps keep jerk limits (planner 1 of 2.10).
    double path_jerk = kUnlimited;  ///< Of each piece, and across arcs.
};

}  // namespace gsim::motion::linuxcnc
