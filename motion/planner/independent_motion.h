#pragma once

#include <optional>

#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

/// Joints that move independently of the program's moves (an independent group of axes): in proportion, from
/// standstill to standstill, as fast as their own limits allow. Moves are planned as if these joints were at
/// their ends already. The remainder of their path is added to each segment as a superimposed motion.
class IndependentMotion {
  public:
    /// Plans the motion of these joints from `start` on to their values in `end`. Errors:
    /// RRS_INVALID_PARAMETER, RRS_ZERO_SPEED.
    static tl::expected<IndependentMotion, PlanError> plan(const PlannerSetup& setup,
                                                           const rrs::JointPos& start,
                                                           const rrs::JointPos& end, double start_s);

    double end_s() const { return start_s_ + law_.duration_s(); }
    /// True if the joint is one of them.
    bool moves(int joint) const { return displacement_[joint] != 0; }
    /// Returns the remainder of their path at a time: their positions minus those of their ends.
    rrs::JointPos remaining(double time_s) const;
    /// Adds the remainder of their path to a segment in which these joints are at their ends.
    void superimpose(Segment& segment) const;

  private:
    IndependentMotion() = default;

    double start_s_ = 0;
    rrs::JointPos displacement_;
    TimeLaw law_;  ///< Law of the path share, 0 to 1.
};

}  // namespace gsim::motion
