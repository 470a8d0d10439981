#include "runtime/cell/motion_bound.h"

#include <cmath>

namespace gsim::cell {

namespace {

constexpr double kOrthogonal = 1e-9;

/// Prismatic joints that follow each other: together they go as their ways add up at right angles, or, where
/// they are not at right angles, one behind the other.
class Slides {
  public:
    void add(const Eigen::Vector3d& direction, double way_mm) {
        for (int i = 0; i < count_; ++i) {
            if (std::abs(directions_[static_cast<std::size_t>(i)].dot(direction)) > kOrthogonal)
                orthogonal_ = false;
        }
        if (count_ == 3) {
            orthogonal_ = false;
        } else {
            directions_[static_cast<std::size_t>(count_++)] = direction;
        }
        sum_ += way_mm;
        square_ += way_mm * way_mm;
    }
    /// An arc in the space of some of the joints: its length counts for all of them.
    void add_arc(double way_mm) {
        if (has_arc_) return;
        has_arc_ = true;
        sum_ += way_mm;
        square_ += way_mm * way_mm;
    }
    double way_mm() const { return orthogonal_ ? std::sqrt(square_) : kSkewed * sum_; }

  private:
    // An arc of joints that are not at right angles: no longer than all three of them together.
    static constexpr double kSkewed = 1.7320508075688774;

    std::array<Eigen::Vector3d, 3> directions_;
    int count_ = 0;
    bool orthogonal_ = true;
    bool has_arc_ = false;
    double sum_ = 0;
    double square_ = 0;
};

}  // namespace

double ChainMotion::reach_mm(const Ball& body, int joint) const {
    const JointAxis& axis = axes_[static_cast<std::size_t>(joint)];
    return axis.direction.cross(body.middle_mm - axis.point_mm).norm() + body.radius_mm;
}

MotionBound ChainMotion::bound(const Ball& body, std::span<const int> between) const {
    MotionBound bound;
    double second_order = 0;
    Slides slides;
    Slides slide_bends;
    const auto end_slides = [&] {
        bound.way_mm += slides.way_mm();
        bound.bend_mm += slide_bends.way_mm();
        slides = slide_bends = {};
    };
    for (const int joint : between) {
        const auto index = static_cast<std::size_t>(joint);
        if (axes_[index].kind == rrs::JointKind::prismatic) {
            slides.add(axes_[index].direction, travel_.way[index]);
            slide_bends.add(axes_[index].direction, travel_.bend[index]);
            if (travel_.on_arc(joint)) {
                slides.add_arc(travel_.arc_mm);
                slide_bends.add_arc(travel_.arc_bend_mm);
            }
            continue;
        }
        end_slides();
        const double angle = travel_.way[index];
        const double reach = reach_mm(body, joint) + bound.way_mm;
        second_order += angle * (2 * bound.way_mm + angle * reach);
        bound.bend_mm += travel_.bend[index] * reach;
        bound.way_mm += angle * reach;
    }
    end_slides();
    bound.bend_mm += second_order / 8;
    return bound;
}

}  // namespace gsim::cell
