#pragma once

#include <memory>
#include <vector>

#include "motion/dynamics/dynamics.h"
#include "motion/dynamics/motor.h"
#include "motion/planner/move_limits.h"

namespace gsim::dynamics {

/// Accelerations that the peaks of the motors allow. At a position q of a path, at the speed v and with the
/// acceleration a along it, the effort of a motor is
///
///     M(q) (q' a + q'' v^2) + (terms with v and v^2, weight, friction, counterweight, hoses)
///
/// by Dynamics::efforts(): affine in a, and a polynomial of v. So the largest a for all speeds up to the top
/// one is found in closed form at each point of the path. Between points the terms are off the line through
/// both by at most their distance from the line at their neighbours (their second difference). This distance
/// is subtracted from the motor: nothing if the terms do not change along the path.
///
/// On a straight path q'' is 0, and speeding up and slowing down have separate limits. Elsewhere
/// accelerations have any direction: each joint gets a separate share, and the shares of all may combine with
/// any sign. A joint without a motor keeps its acceleration; those of the others may be above theirs.
///
/// If the motors have less effort at higher speeds, the top speed is the one at which a move from standstill
/// to standstill takes the least time. For a move that may be passed at any speed, it is not a speed at which
/// less than half of its acceleration is left. Speeds are tried in steps of a half octave.
class EffortLimits final : public motion::MoveLimits {
  public:
    /// Takes one motor for each joint.
    EffortLimits(std::shared_ptr<const Dynamics> dynamics, std::vector<Motor> motors);

    motion::PlanResult limit(motion::LimitedPath& path,
                             std::vector<motion::JointSetup>& joints) const override;

  private:
    struct EffortTerms;
    struct EffortField;
    struct AccelerationBounds;

    EffortTerms effort_terms_at(const motion::PathPoint& point, const EffortField& field) const;
    EffortField make_effort_field(const motion::LimitedPath& path) const;
    void limit_to_top_speeds(motion::LimitedPath& path, const rrs::JointPos& shares) const;
    AccelerationBounds acceleration_bounds(const EffortField& field,
                                           const std::vector<motion::JointSetup>& joints, double part) const;
    AccelerationBounds line_acceleration_bounds(const EffortField& field,
                                                const std::vector<motion::JointSetup>& joints,
                                                double part) const;
    AccelerationBounds any_direction_bounds(const EffortField& field,
                                            const std::vector<motion::JointSetup>& joints, double part) const;
    rrs::JointPos available_efforts(const EffortField& field, double part) const;
    int weakest_joint(const EffortField& field) const;
    AccelerationBounds best(const EffortField& field, const std::vector<motion::JointSetup>& joints,
                            motion::LimitedPath& path) const;

    std::shared_ptr<const Dynamics> dynamics_;
    std::vector<Motor> motors_;
};

}  // namespace gsim::dynamics
