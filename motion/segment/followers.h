#pragma once

#include <array>

#include "motion/path/joint_changes.h"
#include "motion/planner/move_rules.h"
#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

/// Joints that move outside a leading path, each by its own ramps within its own limits.
class Followers {
  public:
    /// Takes all moving joints except those of the role that leads, and of `orientation` if it is not null:
    /// these move with the master law.
    Followers(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes,
              JointRole master, const OrientationArc* orientation);

    /// Returns the least time in which all of them can cover their paths.
    double fastest_s() const { return fastest_s_; }
    /// Returns the limit of the slowest of them.
    LimitCause slowest() const { return slowest_; }
    /// Writes them to the segment, stretched to `duration_s` >= fastest_s().
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
    LimitCause slowest_;
};

/// Returns what the limits of a joint allow it.
LawLimits law_limits(const PlannerSetup& setup, int joint);

/// Returns the same for a joint outside the tool path: the programmed speed and acceleration of orientation
/// apply to each rotary joint by its share of the change of orientation.
LawLimits other_joint_limits(const PlannerSetup& setup, const MoveRules& rules, const JointChanges& changes,
                             int joint);

/// True if a joint moves outside the tool path: it is not one of the role that leads, nor of `orientation` if
/// that is not null, which move with the master law.
bool moves_outside_path(const JointChanges& changes, JointRole master, const OrientationArc* orientation,
                        int joint);

/// Returns what keeps a motion within limits from being faster: its speed, its acceleration or its jerk.
LimitCause reached_limit(const TimeLaw& law, const LawLimits& limits, const LimitCause& speed_limit,
                         const LimitCause& acceleration_limit, const LimitCause& jerk_limit);

}  // namespace gsim::motion
