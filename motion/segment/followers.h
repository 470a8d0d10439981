#pragma once

#include <array>

#include "motion/path/joint_changes.h"
#include "motion/planner/move_rules.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

/// The joints that move beside a lead path, each by ramps of its own within its own limits.
class Followers {
  public:
    /// All moving joints but those of the role that leads, and of `orientation` where it is not null: these
    /// go with the lead.
    Followers(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes, JointRole lead,
              const OrientationArc* orientation);

    /// The least time in which all of them can do their way.
    double fastest_s() const { return fastest_s_; }
    /// What limits the slowest of them.
    LimitedBy slowest() const { return slowest_; }
    /// Gives them to the segment, stretched to `duration_s` >= fastest_s().
    void write(Segment& segment, double duration_s) const;

  private:
    struct Move {
        int joint;
        double change;
        LawLimits limits;
        double fastest_s;
    };

    void add(int joint, double change, const LawLimits& limits);

    std::array<Move, rrs::kMaxJoints> moves_;  // only the first count_ hold values
    std::size_t count_ = 0;
    double fastest_s_ = 0;
    LimitedBy slowest_;
};

/// What the limits of a joint allow it.
LawLimits law_limits(const PlannerSetup& setup, int joint);

/// The same of a joint beside the tool's path: the programmed speed and acceleration of orientation reach
/// each rotary joint in its share of the change of orientation.
LawLimits limits_beside(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes,
                        int joint);

/// Whether a joint moves beside the tool's path: it is none of those of the role that leads, nor of
/// `orientation` where that is not null, which go with the lead.
bool is_beside(const JointChanges& changes, JointRole lead, const OrientationArc* orientation, int joint);

/// What keeps a motion within limits from being faster: its speed, its acceleration or its jerk.
LimitedBy limit_reached(const TimeLaw& law, const LawLimits& limits, const LimitedBy& speed_limit,
                        const LimitedBy& acceleration_limit, const LimitedBy& jerk_limit);

}  // namespace gsim::motion
