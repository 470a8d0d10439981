#pragma once

#include <optional>

#include "motion/planner/plan_error.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

/// Joints that go by themselves beside the moves of the program (an independent group of axes): in
/// proportion, from rest to rest, as fast as their own limits let them. Moves are planned as if they stood at
/// their ends already; what is left of their way is added to each segment as a motion beside it.
class OwnMotion {
  public:
    /// From `start` on, of which these joints go to their values in `end`. RRS_INVALID_PARAMETER,
    /// RRS_ZERO_SPEED.
    static tl::expected<OwnMotion, PlanError> plan(const PlannerSetup& setup, const rrs::JointPos& start,
                                                   const rrs::JointPos& end, double start_s);

    double end_s() const { return start_s_ + law_.duration_s(); }
    /// Whether the joint is one of them.
    bool moves(int joint) const { return way_[joint] != 0; }
    /// What is left of their way at a time: of their places less those of their ends.
    rrs::JointPos left(double time_s) const;
    /// Adds to a segment in which these joints stand at their ends what is left of their way.
    void carry(Segment& segment) const;

  private:
    OwnMotion() = default;

    double start_s_ = 0;
    rrs::JointPos way_;
    TimeLaw law_;  ///< Of the share of the way, 0 to 1.
};

}  // namespace gsim::motion
