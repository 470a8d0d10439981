#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/envelope/tip_chain.h"

namespace gsim::envelope {

/// Positions from which a joint at different values takes a point: the inverse of its motion.
class Orbit {
  public:
    Orbit(const TipJoint& joint, const Vector3d& point) {
        if (joint.is_slide()) {
            middle_ = point;
            across_ = -joint.direction;
            slides_ = true;
            speed_ = 1;
            return;
        }
        const Vector3d arm = point - joint.point_mm;
        out_ = arm - arm.dot(joint.direction) * joint.direction;
        middle_ = point - out_;
        across_ = -joint.direction.cross(out_);
        speed_ = out_.norm();
    }

    Vector3d at(double value) const {
        if (slides_) return middle_ + value * across_;
        return middle_ + std::cos(value) * out_ + std::sin(value) * across_;
    }
    /// Returns mm for each mm or rad of the joint.
    double speed() const { return speed_; }

  private:
    Vector3d middle_;
    Vector3d out_ = Vector3d::Zero();
    Vector3d across_;
    double speed_ = 0;
    bool slides_ = false;
};

/// Smallest distance between a set and a point on its path along a joint.
struct NearestPass {
    double distance_mm = std::numeric_limits<double>::infinity();
    double value = 0;  ///< Joint value there.
};

/// Required accuracy of a smallest distance.
struct PassRule {
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
NearestPass nearest_pass(const TipJoint& joint, const Vector3d& point, double hint, const PassRule& rule,
                         const Distance& distance) {
    const Orbit orbit(joint, point);
    const double start = std::clamp(hint, joint.low, joint.high);
    NearestPass best{distance(orbit.at(start)), start};
    const bool moves = orbit.speed() * (joint.high - joint.low) > rule.tolerance_mm;
    for (double value = joint.low; moves && best.distance_mm > rule.near_mm;) {
        const double here = distance(orbit.at(value));
        if (here < best.distance_mm) best = {here, value};
        if (value >= joint.high) break;
        const double way_mm = here - best.distance_mm + 2 * rule.tolerance_at(best.distance_mm);
        value = std::min(value + way_mm / orbit.speed(), joint.high);
    }
    if (best.distance_mm > rule.band_mm) best.distance_mm -= rule.tolerance_at(best.distance_mm);
    return best;
}

/// Returns a box that holds all positions that a joint gives a box.
Eigen::AlignedBox3d swept(const TipJoint& joint, const Eigen::AlignedBox3d& box);

}  // namespace gsim::envelope
