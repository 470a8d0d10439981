#include "motion/lookahead/corner_window.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/lookahead/corner.h"
#include "motion/path/axis_space.h"

namespace gsim::motion {

namespace {

constexpr int kFewCorners = 8;
constexpr int kCornersBetween = 4;

/// Corners before the newest one that have a lower speed of their own.
class SlowerCorners {
  public:
    explicit SlowerCorners(Eigen::Index joints)
        : turn_(rrs::JointPos::Zero(joints)), jumps_(rrs::JointPos::Zero(joints)) {}

    void add(const rrs::JointPos& change, double speed) {
        turn_ += change;
        jumps_ += speed * change;
        least_ = std::min(least_, speed);
    }
    double turn(Eigen::Index joint) const { return turn_[joint]; }
    double jump(Eigen::Index joint) const { return jumps_[joint]; }  // mm/s or rad/s
    double least() const { return least_; }

  private:
    rrs::JointPos turn_;
    rrs::JointPos jumps_;
    double least_ = kUnlimited;
};

/// Successive corners up to the newest one, which are passed at its speed v or at a lower one of their own.
/// They change the joint speeds together by v turn + before, or by v whole_turn if v is also below all of the
/// lower ones.
class Stretch {
  public:
    Stretch(const rrs::JointPos& slope_in, const rrs::JointPos& slope_out, const SlowerCorners& slower,
            double way)
        : slope_in_(slope_in), slope_out_(slope_out), slower_(slower), way_(way) {}

    Eigen::Index joints() const { return slope_in_.size(); }
    double whole_turn(Eigen::Index joint) const { return slope_out_[joint] - slope_in_[joint]; }
    double turn(Eigen::Index joint) const { return whole_turn(joint) - slower_.turn(joint); }
    double before(Eigen::Index joint) const { return slower_.jump(joint); }
    double change(Eigen::Index joint, double speed) const {
        return std::abs(speed * turn(joint) + before(joint));
    }
    /// Returns the lowest of the corners' own speeds.
    double least() const { return slower_.least(); }
    /// Returns the path length that the corners count for.
    double way() const { return way_; }

  private:
    const rrs::JointPos& slope_in_;
    const rrs::JointPos& slope_out_;
    const SlowerCorners& slower_;
    double way_;
};

/// Limits that the joints tolerate at corners.
class JointBounds {
  public:
    explicit JointBounds(const PlannerSetup& setup) : count_(static_cast<std::size_t>(setup.joint_count())) {
        const double share = setup.controller.centripetal_share;
        for (std::size_t joint = 0; joint < count_; ++joint) {
            const double acceleration = share * setup.joints[joint].least_acceleration();
            bounds_[joint] = {speed_step(setup, static_cast<int>(joint)), acceleration};
            least_acceleration_ = std::min(least_acceleration_, acceleration);
            longest_step_s_ = std::max(longest_step_s_, bounds_[joint].step / acceleration);
        }
    }

    double step(Eigen::Index joint) const { return bounds_[static_cast<std::size_t>(joint)].step; }
    /// Returns the path length at a speed beyond which no stretch limits more than shorter ones. No turn of a
    /// joint, at most from -1 to 1, takes more than its acceleration on a longer one. A stretch that takes
    /// longer than four times the time that the acceleration needs for its step consists of stretches on
    /// which only the acceleration counts.
    double longest_way(double speed) const {
        return 2 * speed * std::min(speed / least_acceleration_, 2 * longest_step_s_);
    }

    bool steps_cover(const Stretch& stretch, double speed) const {
        for (Eigen::Index joint = 0; joint < stretch.joints(); ++joint) {
            if (stretch.change(joint, speed) > step(joint)) return false;
        }
        return true;
    }

    double speed_on(const Stretch& stretch) const {
        double faster = kUnlimited, whole = kUnlimited;
        for (Eigen::Index joint = 0; joint < stretch.joints(); ++joint) {
            faster =
                std::min(faster, speed_of(joint, stretch.turn(joint), stretch.before(joint), stretch.way()));
            whole = std::min(whole, speed_of(joint, stretch.whole_turn(joint), 0, stretch.way()));
        }
        if (faster >= stretch.least() || std::isinf(stretch.least())) return faster;
        return std::max(faster, std::min(stretch.least(), whole));
    }

  private:
    struct Bounds {
        double step = 0;
        double acceleration = 0;

        /// Returns the highest speed v at which a joint keeps to its step, v turn + before <= step, or to its
        /// acceleration, v turn + before <= acceleration way / v.
        double speed(double turn, double before, double way) const {
            const double root = std::sqrt(before * before + 4 * turn * acceleration * way);
            return std::max((step - before) / turn, (root - before) / (2 * turn));
        }
    };

    double speed_of(Eigen::Index joint, double turn, double before, double way) const {
        if (std::abs(turn) < kNoShare) return kUnlimited;
        const Bounds& bounds = bounds_[static_cast<std::size_t>(joint)];
        return bounds.speed(std::abs(turn), turn < 0 ? -before : before, way);
    }

    std::array<Bounds, rrs::kMaxJoints> bounds_;
    std::size_t count_;
    double least_acceleration_ = kUnlimited;
    double longest_step_s_ = 0;
};

/// Returns the part of a block's path that counts for the time that `speed` takes. The motion on a long block
/// speeds up from its corners and slows down again.
double way_at(const Block& block, double speed) {
    if (speed >= block.max_speed) return block.lead.length;
    const double highest = std::sqrt(speed * speed + block.acceleration * block.lead.length);
    return block.lead.length * 2 * speed / (speed + std::min(highest, block.max_speed));
}

/// Calls `look` with the stretches of two and more corners, from the shortest on; of those with many corners
/// only one of four. `speed` is the speed that `look` leaves for the newest. The stretches end at a corner at
/// which the motion stops.
template <typename Look>
void for_each_stretch(const JointBounds& bounds, const BlocksBefore& before, const Block& to,
                      const double& speed, const Look& look) {
    SlowerCorners slower(to.slope_in.size());
    double way = 0;
    int corners = 1;
    for (std::size_t i = before.size(); i-- > 1 && before[i].entry_cap > 0;) {
        const Block& block = before[i];
        way += way_at(block, speed);
        if (way > bounds.longest_way(speed)) return;
        const rrs::JointPos& in = before[i - 1].slope_out;
        const double own = std::min(block.entry_cap, block.max_speed);
        if (own < speed) slower.add(block.slope_in - in, own);
        if (block.move.kind == SegmentKind::circular && block.max_speed < speed)
            slower.add(block.slope_out - block.slope_in, block.max_speed);
        ++corners;
        if (corners <= kFewCorners || corners % kCornersBetween == 0)
            look(Stretch(in, to.slope_in, slower, way * corners / (corners - 1)));
    }
}

/// Returns the joint accelerations that the corners use if their speed steps do not cover them.
rrs::JointPos taken_by_corners(const PlannerSetup& setup, const BlocksBefore& before, const Block& to) {
    const JointBounds bounds(setup);
    const double speed = std::min(to.entry_cap, to.max_speed);
    rrs::JointPos taken = rrs::JointPos::Zero(setup.joint_count());
    for_each_stretch(bounds, before, to, speed, [&](const Stretch& stretch) {
        for (Eigen::Index joint = 0; joint < taken.size(); ++joint) {
            const double change = stretch.change(joint, speed);
            if (change > bounds.step(joint))
                taken[joint] = std::max(taken[joint], speed * change / stretch.way());
        }
    });
    return taken;
}

}  // namespace

WindowSpeed speed_in_window(const PlannerSetup& setup, const BlocksBefore& before, double most,
                            const Block& to) {
    if (!std::isfinite(setup.controller.centripetal_share)) return {most, true};
    const JointBounds bounds(setup);
    WindowSpeed in_window{most, true};
    for_each_stretch(bounds, before, to, in_window.speed, [&](const Stretch& stretch) {
        if (bounds.steps_cover(stretch, in_window.speed)) return;
        in_window = {std::min(in_window.speed, bounds.speed_on(stretch)), false};
    });
    return in_window;
}

void leave_for_corners(const PlannerSetup& setup, const BlocksBefore& before, Block& to) {
    if (setup.controller.centripetal_share >= 1) return;
    const double least = 1 - setup.controller.centripetal_share;
    const rrs::JointPos taken = taken_by_corners(setup, before, to);
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double share = std::abs(to.slope_in[joint]);
        if (taken[joint] <= 0 || share < kNoShare) continue;
        const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
        const auto left = [&](double acceleration) {
            return std::max(acceleration - taken[joint], least * acceleration) / share;
        };
        to.acceleration = std::min(to.acceleration, left(limits.max_acceleration));
        to.deceleration = std::min(to.deceleration, left(limits.deceleration()));
    }
}

}  // namespace gsim::motion
