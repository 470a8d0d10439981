#pragma once

#include <Eigen/Core>
#include <optional>

#include "motion/planner/planner.h"
#include "motion/services/selections.h"

namespace gsim::motion {

/// Services for targets: their type, their motion and its end. A target becomes a Move with all selections of
/// the client. Each service function does the same as the service of its name. It requires Initialize.
class TargetServices {
  public:
    /// Makes the services of a planner for clients with `selections`; both must outlive them.
    TargetServices(Planner& planner, Selections& selections) : planner_(planner), selections_(selections) {}

    PlanResult select_target_type(rrs::TargetType type);
    PlanResult select_motion_type(rrs::MotionType type);
    /// SetTipControl.
    PlanResult set_tcp_control(bool on, const Eigen::Vector3d& tcp_mm);
    PlanResult set_motion_time(double motion_s);
    /// SetRestParameter.
    PlanResult set_dwell(double dwell_s);

    PlanResult set_initial_position(const rrs::CartPos& cartesian, const rrs::JointPos& joints);
    /// Returns RRS_MOTION_TIME_RAISED as an error if the target is enqueued with another time.
    PlanResult set_next_target(rrs::TargetId id, rrs::TargetParam param, const rrs::CartPos& cartesian,
                               const rrs::JointPos& joints, double param_value);
    PlanResult set_next_arc_target(rrs::TargetId id, const Circle& circle, const rrs::CartPos& cartesian,
                                   const rrs::JointPos& joints);
    /// ComeToRest.
    PlanResult plan_to_standstill(rrs::RestReason reason);

    /// Drops the via point of the next target.
    void drop_via() { via_.reset(); }

  private:
    Goal goal(const rrs::CartPos& cartesian, const rrs::JointPos& joints) const;
    Move move_to(rrs::TargetId id, rrs::MotionType type, Goal goal) const;
    PlanResult enqueue(const Move& move);
    PlanResult store_via(const Goal& goal);
    bool can_follow_paths() const;

    Planner& planner_;
    Selections& selections_;
    std::optional<rrs::JointPos> via_;
};

}  // namespace gsim::motion
