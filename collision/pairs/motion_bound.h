#pragma once

#include <span>
#include <vector>

#include "collision/cell/link_frames.h"
#include "collision/pairs/joint_travel.h"

namespace gsim::cell {

/// An arc of three joints that are not at right angles is no longer than this times its length in them: no
/// longer than all three together.
inline constexpr double kSkewedArc = 1.7320508075688774;

/// What no point of a body passes in a part of a motion, in mm.
struct MotionBound {
    double way_mm = 0;  ///< The length of the point's way.
    /// Its distance from the straight way that it would take from start to end. 0 where the body goes
    /// straight without turning.
    double bend_mm = 0;
};

/// A ball in the world that holds a body.
struct Ball {
    Eigen::Vector3d middle_mm;
    double radius_mm;
};

/// How far from the axis of each joint that turns the points of bodies are at most that it moves, in mm; 0
/// where it moves none, and of joints that slide.
using JointReach = std::array<double, rrs::kMaxJoints>;

/// How far a link goes by itself, straight and evenly: the two joints of its own (joints_to()).
struct DriftTravel {
    double way_mm;
    double angle_rad;
    Eigen::Vector3d origin_mm;  ///< Of the link where the motion begins; in the world, as
    Eigen::Vector3d axis;       ///< the unit vector about which it turns.
};

/// The axes of a machine's joints where a motion begins, and how far the joints go. Of two machines in one
/// world: joints of the second are numbered behind all of the first one's.
class ChainMotion {
  public:
    ChainMotion(std::vector<JointAxis> axes, const JointTravel& travel, std::vector<DriftTravel> drifted = {})
        : axes_(std::move(axes)), travel_(travel), drifted_(std::move(drifted)) {}
    /// Of two machines, none of whose links goes by itself.
    ChainMotion(ChainMotion first, ChainMotion second) : ChainMotion(std::move(first)) {
        second_.push_back(std::move(second));
    }

    /// Of a body that the joints `between` move, from its own one on (joints_between()), seen from the link
    /// behind the last of them. A prismatic joint moves its points by its own way; a revolute one by its
    /// angle times the reach of the body from its axis, which joints nearer to the body may lengthen. The
    /// bend is that of x(q) by its second derivatives, an eighth of their bound, with that of the joints' own
    /// ways.
    MotionBound bound(const Ball& body, std::span<const int> between) const;
    /// Makes the reaches of the machine's joints among these as great as where the motion begins.
    void widen(JointReach& reach_mm, const Ball& body, std::span<const int> between) const;

  private:
    std::vector<JointAxis> axes_;
    JointTravel travel_;
    std::vector<DriftTravel> drifted_;
    std::vector<ChainMotion> second_;  ///< One at most.
};

}  // namespace gsim::cell
