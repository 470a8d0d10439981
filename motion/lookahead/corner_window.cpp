#include "motion/lookahead/corner_window.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/lookahead/corner.h"
#include "motion/path/axis_space.h"

namespace gsim::motion {

namespace {

constexpr int kMaxCornersCheckedEach = 8;
constexpr int kCornerStride = 4;

/// Corners before the newest one that have a lower speed of their own.
class SlowerCorners {
  public:
    explicit SlowerCorners(Eigen::Index joints)
        : slope_changes_(rrs::JointPos::Zero(joints)), jumps_(rrs::JointPos::Zero(joints)) {}

    void add(const rrs::JointPos& change, double speed) {
        slope_changes_ += change;
        jumps_ += speed * change;
        min_speed_ = std::min(min_speed_, speed);
    }
    double turn(Eigen::Index joint) const { return slope_changes_[joint]; }
    double jump(Eigen::Index joint) const { return jumps_[joint]; }  // mm/s or rad/s
    double min() const { return min_speed_; }

  private:
    rrs::JointPos slope_changes_;
    rrs::JointPos jumps_;
    double min_speed_ = kUnlimited;
};

/// Successive corners up to the newest one, which are passed at its speed v or at a lower one of their own.
/// They change the joint speeds together by v turn + before, or by v total_change if v is also below all of
/// the lower ones.
class CornerSequence {
  public:
    CornerSequence(const rrs::JointPos& slope_in, const rrs::JointPos& slope_out, const SlowerCorners& slower,
                   double distance)
        : slope_in_(slope_in), slope_out_(slope_out), slower_corners_(slower), distance_(distance) {}

    Eigen::Index joints() const { return slope_in_.size(); }
    double total_change(Eigen::Index joint) const { return slope_out_[joint] - slope_in_[joint]; }
    double turn(Eigen::Index joint) const { return total_change(joint) - slower_corners_.turn(joint); }
    double before(Eigen::Index joint) const { return slower_corners_.jump(joint); }
    double change(Eigen::Index joint, double speed) const {
        return std::abs(speed * turn(joint) + before(joint));
    }
    /// Returns the lowest of the corners' own speeds.
    double min() const { return slower_corners_.min(); }
    /// Returns the path length that the corners count for.
    double distance() const { return distance_; }

  private:
    const rrs::JointPos& slope_in_;
    const rrs::JointPos& slope_out_;
    const SlowerCorners& slower_corners_;
    double distance_;
};

/// Limits that the joints tolerate at corners.
class JointBounds {
  public:
    explicit JointBounds(const PlannerSetup& setup) : count_(static_cast<std::size_t>(setup.joint_count())) {
        const double share = setup.controller.ramps.centripetal_share;
        for (std::size_t joint = 0; joint < count_; ++joint) {
            const double acceleration = share * setup.joints[joint].min_acceleration();
            bounds_[joint] = {speed_step(setup, static_cast<int>(joint)), acceleration};
            min_acceleration_ = std::min(min_acceleration_, acceleration);
            max_step_time_s_ = std::max(max_step_time_s_, bounds_[joint].step / acceleration);
        }
    }

    double step(Eigen::Index joint) const { return bounds_[static_cast<std::size_t>(joint)].step; }
    /// Returns the path length at a speed beyond which no stretch limits more than shorter ones. No turn of a
    /// joint, at most from -1 to 1, takes more than its acceleration on a longer one. A stretch that takes
    /// longer than four times the time that the acceleration needs for its step consists of stretches on
    /// which only the acceleration counts.
    double max_distance(double speed) const {
        return 2 * speed * std::min(speed / min_acceleration_, 2 * max_step_time_s_);
    }

    bool is_within_speed_steps(const CornerSequence& corner_sequence, double speed) const {
        for (Eigen::Index joint = 0; joint < corner_sequence.joints(); ++joint) {
            if (corner_sequence.change(joint, speed) > step(joint)) return false;
        }
        return true;
    }

    double max_speed_on(const CornerSequence& corner_sequence) const {
        double faster = kUnlimited, full_turn_speed = kUnlimited;
        for (Eigen::Index joint = 0; joint < corner_sequence.joints(); ++joint) {
            faster = std::min(
                faster, joint_speed_limit(joint, corner_sequence.turn(joint), corner_sequence.before(joint),
                                          corner_sequence.distance()));
            full_turn_speed = std::min(
                full_turn_speed,
                joint_speed_limit(joint, corner_sequence.total_change(joint), 0, corner_sequence.distance()));
        }
        if (faster >= corner_sequence.min() || std::isinf(corner_sequence.min())) return faster;
        return std::max(faster, std::min(corner_sequence.min(), full_turn_speed));
    }

  private:
    struct Bounds {
        double step = 0;
        double acceleration = 0;

        /// Returns the highest speed v at which a joint keeps to its step, v turn + before <= step, or to its
        /// acceleration, v turn + before <= acceleration distance / v.
        double speed(double turn, double before, double distance) const {
            const double root = std::sqrt(before * before + 4 * turn * acceleration * distance);
            return std::max((step - before) / turn, (root - before) / (2 * turn));
        }
    };

    double joint_speed_limit(Eigen::Index joint, double turn, double before, double distance) const {
        if (std::abs(turn) < kMinShare) return kUnlimited;
        const Bounds& bounds = bounds_[static_cast<std::size_t>(joint)];
        return bounds.speed(std::abs(turn), turn < 0 ? -before : before, distance);
    }

    std::array<Bounds, rrs::kMaxJoints> bounds_;
    std::size_t count_;
    double min_acceleration_ = kUnlimited;
    double max_step_time_s_ = 0;
};

/// Returns the part of a block's path that counts for the time that `speed` takes. The motion on a long block
/// speeds up from its corners and slows down again.
double distance_at(const Block& block, double speed) {
    if (speed >= block.max_speed) return block.master.length;
    const double highest = std::sqrt(speed * speed + block.acceleration * block.master.length);
    return block.master.length * 2 * speed / (speed + std::min(highest, block.max_speed));
}

/// Calls `visit_window` with the stretches of two and more corners, from the shortest on; of those with many
/// corners only one of four. `speed` is the speed that `visit_window` leaves for the newest. The stretches
/// end at a corner at which the motion stops.
template <typename Visitor>
void for_each_corner_sequence(const JointBounds& bounds, const PrecedingBlocks& before, const Block& to,
                              const double& speed, const Visitor& visit_window) {
    SlowerCorners slower(to.slope_in.size());
    double distance = 0;
    int corners = 1;
    for (std::size_t i = before.size(); i-- > 1 && before[i].entry_cap > 0;) {
        const Block& block = before[i];
        distance += distance_at(block, speed);
        if (distance > bounds.max_distance(speed)) return;
        const rrs::JointPos& in = before[i - 1].slope_out;
        const double block_speed = std::min(block.entry_cap, block.max_speed);
        if (block_speed < speed) slower.add(block.slope_in - in, block_speed);
        if (block.move.kind == SegmentKind::circular && block.max_speed < speed)
            slower.add(block.slope_out - block.slope_in, block.max_speed);
        ++corners;
        if (corners <= kMaxCornersCheckedEach || corners % kCornerStride == 0)
            visit_window(CornerSequence(in, to.slope_in, slower, distance * corners / (corners - 1)));
    }
}

/// Returns the joint accelerations that the corners use if their speed steps do not cover them.
rrs::JointPos accelerations_for_corners(const PlannerSetup& setup, const PrecedingBlocks& before,
                                        const Block& to) {
    const JointBounds bounds(setup);
    const double speed = std::min(to.entry_cap, to.max_speed);
    rrs::JointPos used = rrs::JointPos::Zero(setup.joint_count());
    for_each_corner_sequence(bounds, before, to, speed, [&](const CornerSequence& corner_sequence) {
        for (Eigen::Index joint = 0; joint < used.size(); ++joint) {
            const double change = corner_sequence.change(joint, speed);
            if (change > bounds.step(joint))
                used[joint] = std::max(used[joint], speed * change / corner_sequence.distance());
        }
    });
    return used;
}

}  // namespace

WindowSpeed speed_in_window(const PlannerSetup& setup, const PrecedingBlocks& before, double speed_cap,
                            const Block& to) {
    if (!std::isfinite(setup.controller.ramps.centripetal_share)) return {speed_cap, true};
    const JointBounds bounds(setup);
    WindowSpeed window_speed{speed_cap, true};
    for_each_corner_sequence(
        bounds, before, to, window_speed.speed, [&](const CornerSequence& corner_sequence) {
            if (bounds.is_within_speed_steps(corner_sequence, window_speed.speed)) return;
            window_speed = {std::min(window_speed.speed, bounds.max_speed_on(corner_sequence)), false};
        });
    return window_speed;
}

void reserve_for_corners(const PlannerSetup& setup, const PrecedingBlocks& before, Block& to) {
    if (setup.controller.ramps.centripetal_share >= 1) return;
    const double min = 1 - setup.controller.ramps.centripetal_share;
    const rrs::JointPos used = accelerations_for_corners(setup, before, to);
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double share = std::abs(to.slope_in[joint]);
        if (used[joint] <= 0 || share < kMinShare) continue;
        const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
        const auto remaining = [&](double acceleration) {
            return std::max(acceleration - used[joint], min * acceleration) / share;
        };
        to.acceleration = std::min(to.acceleration, remaining(limits.max_acceleration));
        to.deceleration = std::min(to.deceleration, remaining(limits.deceleration()));
    }
}

}  // namespace gsim::motion
