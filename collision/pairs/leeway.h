#pragma once

#include <array>

#include "collision/pairs/joint_travel.h"
#include "collision/pairs/motion_bound.h"

namespace gsim::cell {

/// How far the points of a machine's bodies go at most, known from how its joints go alone.
class ReachBound {
  public:
    /// Reaches of the joints, as they are where points have gone no more than `since_mm` since.
    void measure(const JointReach& reach_mm, double since_mm) {
        reach_mm_ = reach_mm;
        since_mm_ = since_mm;
    }
    /// Infinite where the joints turn so far that it is not told.
    double way_mm(const JointTravel& travel) const;
    /// The points have gone that far.
    void go_on(double way_mm) { since_mm_ += way_mm; }

  private:
    JointReach reach_mm_{};
    double since_mm_ = 0;
};

/// How far a machine may go before any of its bodies can come near another one, so that motion far from
/// everything need not be looked at body by body.
class Leeway {
  public:
    /// No two bodies come near each other before they have gone `slack_mm` against each other. Since the
    /// reaches were measured no point of a body has gone more than `since_mm`.
    void set(double slack_mm, const JointReach& reach_mm, double since_mm);
    void clear() { slack_mm_ = 0; }
    /// Whether that motion uses up no more than is left; then it is counted as gone.
    bool take(const JointTravel& travel);
    /// Whether there is so much that it pays to use it for motion that goes as far as that.
    static bool pays(double slack_mm, double way_mm) { return slack_mm > kLeastMotions * way_mm; }
    /// How far all bodies may have gone in motion that was taken, and from now on 0.
    double release_gone_mm();

  private:
    static constexpr double kLeastMotions = 4;

    double slack_mm_ = 0;
    double gone_mm_ = 0;
    ReachBound bound_;
};

}  // namespace gsim::cell
