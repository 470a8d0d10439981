#include "collision/pairs/motion_bound.h"

#include <algorithm>
#include <cmath>

namespace gsim::cell {

namespace {

constexpr double kOrthogonal = 1e-9;

/// Returns the max distance of a body's points from an axis.
double reach(const BoundingSphere& body, const Eigen::Vector3d& point_mm, const Eigen::Vector3d& axis) {
    return axis.cross(body.middle_mm - point_mm).norm() + body.radius_mm;
}

/// Prismatic joints that follow each other. Their distances add up at right angles or, if they are not at
/// right angles, end to end.
class SlideSum {
  public:
    void add(const Eigen::Vector3d& direction, double travel_mm) {
        for (int i = 0; i < count_; ++i) {
            if (std::abs(directions_[static_cast<std::size_t>(i)].dot(direction)) > kOrthogonal)
                orthogonal_ = false;
        }
        if (count_ == 3) {
            orthogonal_ = false;
        } else {
            directions_[static_cast<std::size_t>(count_++)] = direction;
        }
        sum_ += travel_mm;
        square_ += travel_mm * travel_mm;
    }
    /// Adds an arc in the space of some of the joints: its length counts for all of them.
    void add_arc(double travel_mm) {
        if (has_arc_) return;
        has_arc_ = true;
        sum_ += travel_mm;
        square_ += travel_mm * travel_mm;
    }
    double travel_mm() const { return orthogonal_ ? std::sqrt(square_) : kSkewedArcFactor * sum_; }

  private:
    std::array<Eigen::Vector3d, 3> directions_;
    int count_ = 0;
    bool orthogonal_ = true;
    bool has_arc_ = false;
    double sum_ = 0;
    double square_ = 0;
};

/// Sum over the joints, from the body on.
class BoundSum {
  public:
    explicit BoundSum(const BoundingSphere& body) : body_(body) {}

    void slide(const Eigen::Vector3d& direction, double travel_mm, double deviation_mm) {
        slides_.add(direction, travel_mm);
        slide_deviations_.add(direction, deviation_mm);
    }
    void add_arc_slide(double travel_mm, double deviation_mm) {
        slides_.add_arc(travel_mm);
        slide_deviations_.add_arc(deviation_mm);
    }
    /// Adds a slide in any direction.
    void link_travel(double travel_mm) {
        close_slides();
        bound_.travel_mm += travel_mm;
    }
    void turn(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& axis, double angle, double deviation) {
        close_slides();
        const double reach_mm = reach(body_, point_mm, axis) + bound_.travel_mm;
        second_order_ += angle * (2 * bound_.travel_mm + angle * reach_mm);
        bound_.deviation_mm += deviation * reach_mm;
        bound_.travel_mm += angle * reach_mm;
    }
    /// Closes the current slides, because later ones do not add up with them.
    void close_slides() {
        bound_.travel_mm += slides_.travel_mm();
        bound_.deviation_mm += slide_deviations_.travel_mm();
        slides_ = slide_deviations_ = {};
    }
    MotionBound result() {
        close_slides();
        bound_.deviation_mm += second_order_ / 8;
        return bound_;
    }

  private:
    const BoundingSphere& body_;
    MotionBound bound_;
    double second_order_ = 0;
    SlideSum slides_;
    SlideSum slide_deviations_;
};

}  // namespace

MotionBound ChainMotion::bound(const BoundingSphere& body, std::span<const int> between) const {
    BoundSum sum(body);
    const ChainMotion* last = this;
    for (const int joint : between) {
        auto index = static_cast<std::size_t>(joint);
        const ChainMotion* chain = this;
        if (!second_.empty() && index >= axes_.size()) {
            chain = &second_.front();
            index -= axes_.size();
        }
        if (chain != last) sum.close_slides();  // slides of different machines are at no known angle
        last = chain;
        if (index >= chain->axes_.size()) {
            const std::size_t drift_index = index - chain->axes_.size();
            const LinkTravel& link_travel = chain->link_travels_[drift_index / 2];
            if (drift_index % 2 == 0) {
                sum.link_travel(link_travel.travel_mm);
            } else {
                sum.turn(link_travel.origin_mm, link_travel.axis, link_travel.angle_rad, 0);
            }
            continue;
        }
        const JointAxis& axis = chain->axes_[index];
        const JointTravel& travel = chain->travel_;
        if (axis.kind == rrs::JointKind::prismatic) {
            sum.slide(axis.direction, travel.distance[index], travel.deviation[index]);
            if (travel.is_on_arc(static_cast<int>(index)))
                sum.add_arc_slide(travel.arc_mm, travel.arc_deviation_mm);
        } else {
            sum.turn(axis.point_mm, axis.direction, travel.distance[index], travel.deviation[index]);
        }
    }
    return sum.result();
}

void ChainMotion::expand(JointReach& reach_mm, const BoundingSphere& body,
                         std::span<const int> between) const {
    for (const int joint : between) {
        const auto index = static_cast<std::size_t>(joint);
        if (index >= axes_.size() || axes_[index].kind == rrs::JointKind::prismatic) continue;
        reach_mm[index] =
            std::max(reach_mm[index], reach(body, axes_[index].point_mm, axes_[index].direction));
    }
}

}  // namespace gsim::cell
