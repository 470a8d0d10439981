#pragma once

#include <span>
#include <vector>

#include "collision/cell/link_frames.h"
#include "collision/pairs/joint_travel.h"

namespace gsim::cell {

/// Factor for an arc of three joints that are not at right angles. The arc is no longer than this times its
/// length in them: no longer than all three together.
inline constexpr double kSkewedArcFactor = 1.7320508075688774;

/// Bounds that no point of a body exceeds in a part of a motion, in mm.
struct MotionBound {
    double travel_mm = 0;  ///< Length of the point's path.
    /// Distance from the straight path from start to end. 0 if the body moves straight without turning.
    double deviation_mm = 0;
};

/// Ball in the world that holds a body.
struct BoundingSphere {
    Eigen::Vector3d middle_mm;
    double radius_mm;
};

/// Max distance of the body points that a revolute joint moves from its axis, in mm; 0 for a joint that moves
/// none, and for sliding joints.
using JointReach = std::array<double, rrs::kMaxJoints>;

/// Straight and even travel of an independently moving link: its own two joints (joints_to()).
struct LinkTravel {
    double travel_mm;
    double angle_rad;
    Eigen::Vector3d origin_mm;  ///< Link origin at the start of the motion; in the world, as
    Eigen::Vector3d axis;       ///< the unit vector about which it turns.
};

/// Axes of a machine's joints at the start of a motion, and the travel of the joints. For two machines in one
/// world, joints of the second are numbered on from those of the first.
class ChainMotion {
  public:
    ChainMotion(std::vector<JointAxis> axes, const JointTravel& travel,
                std::vector<LinkTravel> link_travels = {})
        : axes_(std::move(axes)), travel_(travel), link_travels_(std::move(link_travels)) {}
    /// Combines two machines without independently moving links.
    ChainMotion(ChainMotion first, ChainMotion second) : ChainMotion(std::move(first)) {
        second_.push_back(std::move(second));
    }

    /// Returns the bound for a body that the joints `between` move, from its own one on (joints_between()),
    /// seen from the link that follows the last of them. A prismatic joint moves its points by its own
    /// distance. A revolute one moves them by its angle times the reach of the body from its axis, which
    /// joints nearer to the body may lengthen. The deviation is that of x(q) by its second derivatives, an
    /// eighth of their bound, plus that of the joints' own paths.
    MotionBound bound(const BoundingSphere& body, std::span<const int> between) const;
    /// Enlarges the reaches of the machine's joints among these to their values at the start of the motion.
    void expand(JointReach& reach_mm, const BoundingSphere& body, std::span<const int> between) const;

  private:
    std::vector<JointAxis> axes_;
    JointTravel travel_;
    std::vector<LinkTravel> link_travels_;
    std::vector<ChainMotion> second_;  ///< At most one.
};

}  // namespace gsim::cell
