#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/envelope/tcp_chain.h"

namespace gsim::envelope {

/// Positions from which a joint at different values takes a point: the inverse of its motion.
class JointPointPath {
  public:
    JointPointPath(const TcpJoint& joint, const Vector3d& point) {
        if (joint.is_slide()) {
            middle_ = point;
            tangent_ = -joint.direction;
            slides_ = true;
            speed_ = 1;
            return;
        }
        const Vector3d arm = point - joint.point_mm;
        radial_ = arm - arm.dot(joint.direction) * joint.direction;
        middle_ = point - radial_;
        tangent_ = -joint.direction.cross(radial_);
        speed_ = radial_.norm();
    }

    Vector3d at(double value) const {
        if (slides_) return middle_ + value * tangent_;
        return middle_ + std::cos(value) * radial_ + std::sin(value) * tangent_;
    }
    /// Returns mm for each mm or rad of the joint.
    double speed() const { return speed_; }

  private:
    Vector3d middle_;
    Vector3d radial_ = Vector3d::Zero();
    Vector3d tangent_;
    double speed_ = 0;
    bool slides_ = false;
};

/// Smallest distance between a set and a point on its path along a joint.
struct ClosestApproach {
    double distance_mm = std::numeric_limits<double>::infinity();
    double value = 0;  ///< Joint value there.
};

/// Required accuracy of a smallest distance.
struct ApproachAccuracy {
    double tolerance_mm;
    double near_mm;  ///< A distance that is no more than this is good enough.
    /// Distance above which a lower bound is enough, 0.7 of it or better.
    double band_mm = std::numeric_limits<double>::infinity();

    double tolerance_at(double distance_mm) const {
        return std::max(tolerance_mm, 0.3 * (distance_mm - band_mm));
    }
};

/// Returns the smallest distance(x) over all positions that a joint gives a set. A distance does not change
/// by more than the travel, so distant parts are passed in long steps (as in sphere tracing: J. C. Hart, The
/// Visual Computer 12, 1996). `hint` is a value of the joint at which it may be near.
template <typename Distance>
ClosestApproach find_closest_approach(const TcpJoint& joint, const Vector3d& point, double hint,
                                      const ApproachAccuracy& rule, const Distance& distance) {
    const JointPointPath orbit(joint, point);
    const double start = std::clamp(hint, joint.low, joint.high);
    ClosestApproach best{distance(orbit.at(start)), start};
    const bool moves = orbit.speed() * (joint.high - joint.low) > rule.tolerance_mm;
    for (double value = joint.low; moves && best.distance_mm > rule.near_mm;) {
        const double current = distance(orbit.at(value));
        if (current < best.distance_mm) best = {current, value};
        if (value >= joint.high) break;
        const double step_mm = current - best.distance_mm + 2 * rule.tolerance_at(best.distance_mm);
        value = std::min(value + step_mm / orbit.speed(), joint.high);
    }
    if (best.distance_mm > rule.band_mm) best.distance_mm -= rule.tolerance_at(best.distance_mm);
    return best;
}

/// Returns a box that holds all positions that a joint gives a box.
Eigen::AlignedBox3d swept_box(const TcpJoint& joint, const Eigen::AlignedBox3d& box);

}  // namespace gsim::envelope
