#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "collision/cell/cell.h"
#include "collision/pairs/candidate_pairs.h"
#include "motion/segment/segment.h"

namespace gsim::cell {

/// Two bodies that come near each other.
struct Obstacle {
    ItemPair items;
    double distance_mm;
    double t_s;
    Eigen::Vector3d point_mm;  ///< In the world, on the second item.
};

/// Check of paths that a machine could take against the bodies of its cell, in any order and with the process
/// off. No body is missed, as in ClearanceMonitor. A body may be reported or not if it comes as near as the
/// distance within a thousandth of a mm.
class CollisionChecker {
  public:
    /// Makes the check. `cell` and `machine`, for which it was read, must outlive this; its frames keep their
    /// positions. The error is a message: some of them move independently.
    static Result<CollisionChecker> make(const Cell& cell, const machine::Machine& machine);

    /// Returns two bodies that come nearer to each other than requested, if any do. `distance_mm` is theirs
    /// at `t_s` since the start of the segment, which need not be the time of the smallest distance.
    std::optional<Obstacle> obstacle(const motion::Segment& segment, double clearance_mm) const;
    /// Returns the same for a machine at standstill.
    std::optional<Obstacle> obstacle_at(const rrs::JointPos& joints, double clearance_mm) const;

    const Cell& cell() const { return *cell_; }
    /// Returns how many pairs of bodies can meet, without those of the jet.
    std::size_t pair_count() const { return pairs_.size(); }

  private:
    CollisionChecker(const Cell& cell, std::shared_ptr<const kinematics::Kinematics> kinematics);

    const Cell* cell_;
    std::shared_ptr<const kinematics::Kinematics> kinematics_;
    std::vector<CandidatePair> pairs_;
    mutable std::size_t last_ = 0;  ///< Pair that was the last obstacle; it is checked first.
};

}  // namespace gsim::cell
