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
        travel_since_measured_mm_ = since_mm;
    }
    /// Returns infinity if the joints turn so far that no bound is known.
    double travel_mm(const JointTravel& travel) const;
    /// Adds that travel of the points.
    void advance(double travel_mm) { travel_since_measured_mm_ += travel_mm; }

  private:
    JointReach reach_mm_{};
    double travel_since_measured_mm_ = 0;
};

/// Separation budget: distance that a machine may move before any of its bodies can come near another one. So
/// motion far from everything needs no check body by body.
class SeparationBudget {
  public:
    /// Sets the budget: no two bodies come near each other before they have moved `budget_mm` relative to
    /// each other. Since the reaches were measured no point of a body has moved more than `since_mm`.
    void set(double budget_mm, const JointReach& reach_mm, double since_mm);
    void clear() { budget_mm_ = 0; }
    /// Returns true if that motion uses up no more than the remaining budget; it is then counted as
    /// travelled.
    bool spend(const JointTravel& travel);
    /// Returns true if the budget is large enough to be useful for motion of that length.
    static bool is_worthwhile(double budget_mm, double travel_mm) {
        return budget_mm > kMinMotions * travel_mm;
    }
    /// Returns the max travel of all bodies in accepted motion, and resets it to 0.
    double release_travelled_mm();

  private:
    static constexpr double kMinMotions = 4;

    double budget_mm_ = 0;
    double travelled_mm_ = 0;
    ReachBound bound_;
};

}  // namespace gsim::cell
