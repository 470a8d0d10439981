#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "collision/cell/cell.h"
#include "collision/pairs/meeting_pairs.h"
#include "motion/segment/segment.h"

namespace gsim::cell {

/// Two bodies that come near each other.
struct Obstacle {
    ItemPair items;
    double distance_mm;
    double t_s;
    Eigen::Vector3d point_mm;  ///< In the world, on the second item.
};

/// Whether ways that a machine could take lead past the bodies of its cell, asked in any order and with the
/// jet off. No body is passed over, as in ClearanceWatch; but where a body comes as near as the distance
/// within a thousandth of a mm it may be told either way.
class ClearWay {
  public:
    /// `cell` and `machine`, for which it was read, must outlive this; its frames stay where they are. The
    /// error is a sentence: some of them go by themselves.
    static tl::expected<ClearWay, std::string> make(const Cell& cell, const machine::Machine& machine);

    /// Two bodies that come nearer to each other than is asked for, if any do. `distance_mm` is theirs at
    /// `t_s` since the start of the segment, which need not be where they are nearest.
    std::optional<Obstacle> obstacle(const motion::Segment& segment, double clearance_mm) const;
    /// The same of a machine that stands.
    std::optional<Obstacle> obstacle_at(const rrs::JointPos& joints, double clearance_mm) const;

    const Cell& cell() const { return *cell_; }
    /// How many pairs of bodies can meet; the jet's are not among them.
    std::size_t pair_count() const { return pairs_.size(); }

  private:
    ClearWay(const Cell& cell, std::shared_ptr<const kinematics::Kinematics> kinematics);

    const Cell* cell_;
    std::shared_ptr<const kinematics::Kinematics> kinematics_;
    std::vector<MeetingPair> pairs_;
    mutable std::size_t last_ = 0;  ///< The pair that was in the way last is asked first.
};

}  // namespace gsim::cell
