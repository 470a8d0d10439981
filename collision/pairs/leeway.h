#pragma once

#include <array>

#include "collision/pairs/joint_travel.h"
#include "collision/pairs/motion_bound.h"

namespace gsim::cell {

/// Upper bound of the travel of the points of a machine's bodies, known from its joint motion alone.
class ReachBound {
  public:
    /// Sets the reaches of the joints, measured at a pose since which points have moved at most `since_mm`.
    void measure(const JointReach& reach_mm, double since_mm) {
        reach_mm_ = reach_mm;
        since_mm_ = since_mm;
    }
    /// Returns infinity if the joints turn so far that no bound is known.
    double way_mm(const JointTravel& travel) const;
    /// Adds that travel of the points.
    void go_on(double way_mm) { since_mm_ += way_mm; }

  private:
    JointReach reach_mm_{};
    double since_mm_ = 0;
};

/// Separation budget: distance that a machine may move before any of its bodies can come near another one. So
/// motion far from everything needs no check body by body.
class Leeway {
  public:
    /// Sets the budget: no two bodies come near each other before they have moved `slack_mm` relative to each
    /// other. Since the reaches were measured no point of a body has moved more than `since_mm`.
    void set(double slack_mm, const JointReach& reach_mm, double since_mm);
    void clear() { slack_mm_ = 0; }
    /// Returns true if that motion uses up no more than the remaining budget; it is then counted as
    /// travelled.
    bool take(const JointTravel& travel);
    /// Returns true if the budget is large enough to be useful for motion of that length.
    static bool pays(double slack_mm, double way_mm) { return slack_mm > kLeastMotions * way_mm; }
    /// Returns the max travel of all bodies in accepted motion, and resets it to 0.
    double release_gone_mm();

  private:
    static constexpr double kLeastMotions = 4;

    double slack_mm_ = 0;
    double gone_mm_ = 0;
    ReachBound bound_;
};

}  // namespace gsim::cell
