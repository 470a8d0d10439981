#pragma once

#include "motion/planner/plan_error.h"
#include "motion/services/selections.h"

namespace gsim::motion {

/// Services that select how the targets that follow are passed, and the rule for the time of a path. Each
/// service function does the same as the service of its name. It requires Initialize.
class PathModeServices {
  public:
    /// Makes the services of `selections`, which must outlive them. `can_pass_targets`: the planner's moves
    /// may end without a stop.
    PathModeServices(Selections& selections, bool can_pass_targets)
        : selections_(selections), can_pass_targets_(can_pass_targets) {}

    PlanResult select_flyby_mode(bool on);
    PlanResult set_path_mode(rrs::PathMode mode, double tolerance_mm, double merge_tolerance_mm);
    PlanResult select_dominant_interpolation(rrs::Dominance dominance);
    void set_rapid(bool on) { selections_.move_parameters.rapid = on; }

  private:
    Selections& selections_;
    bool can_pass_targets_;
};

}  // namespace gsim::motion
