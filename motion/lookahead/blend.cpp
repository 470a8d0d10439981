#include "motion/lookahead/blend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.h"
#include "motion/path/axis_space.h"
#include "motion/profile/ramp.h"

namespace gsim::motion {

namespace {

constexpr double kChangeTolerance = 1e-9;  // difference of slopes
constexpr double kCutTolerance = 1e-10;    // mm or rad

/// Quantity that changes direction at a corner, per path length, and the limits of this change.
struct DirectionChange {
    double change;
    double acceleration;
    double jerk;
};

/// Norms of the direction changes.
struct DirectionChangeNorms {
    double master = 0;  ///< Norm of the master joints.
    double prismatic = 0;
    double rotary = 0;
};

DirectionChangeNorms direction_change_norms(const PlannerSetup& setup, JointRole master,
                                            const rrs::JointPos& turn) {
    DirectionChangeNorms squares;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const JointRole role = setup.role(joint);
        const double square = turn[joint] * turn[joint];
        if (role == master) squares.master += square;
        (role == JointRole::rotary ? squares.rotary : squares.prismatic) += square;
    }
    return {std::sqrt(squares.master), std::sqrt(squares.prismatic), std::sqrt(squares.rotary)};
}

/// Limits of the speed through a blend.
class BlendSpeedLimits {
  public:
    BlendSpeedLimits(const PlannerSetup& setup, const Block& from, const Block& to, const rrs::JointPos& turn,
                     const DirectionChangeNorms& norms) {
        for (int joint = 0; joint < setup.joint_count(); ++joint) {
            const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
            add({std::abs(turn[joint]), limits.min_acceleration(),
                 setup.controller.ramps.limit_jerk ? limits.max_jerk : kUnlimited});
        }
        // The acceleration along the path is largest at the ends of a blend, with half of the turn as its
        // share.
        const MoveRules& in = from.move.rules;
        const MoveRules& out = to.move.rules;
        if (from.master.role != JointRole::rotary)
            add({norms.master * norms.master / 2,
                 std::min(in.path_acceleration_mm_s2, out.path_acceleration_mm_s2), kUnlimited});
        add({norms.rotary, std::min(in.orientation_acceleration_rad_s2, out.orientation_acceleration_rad_s2),
             kUnlimited});
    }

    double speed(double cut, bool smooth) const {
        double speed = kUnlimited;
        for (std::size_t i = 0; i < count_; ++i) {
            const DirectionChange& turn = turns_[i];
            speed = std::min(speed, std::sqrt((smooth ? 1 : 2) * cut * turn.acceleration / turn.change));
            if (smooth) speed = std::min(speed, std::cbrt(turn.jerk / turn.change * cut * cut));
        }
        return speed;
    }

    /// Returns the smallest cut for a speed.
    double cut(double speed, bool smooth) const {
        double cut = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const DirectionChange& turn = turns_[i];
            const double square = speed * speed * turn.change;
            cut = std::max(cut, square / turn.acceleration / (smooth ? 1 : 2));
            if (smooth) cut = std::max(cut, std::sqrt(square * speed / turn.jerk));
        }
        return cut;
    }

  private:
    void add(const DirectionChange& turn) {
        if (turn.change >= kChangeTolerance) turns_[count_++] = turn;
    }

    std::array<DirectionChange, rrs::kMaxJoints + 2> turns_{};
    std::size_t count_ = 0;
};

/// Returns the cut that moves a quantity which turns by `turn` off the corner by `tolerance`.
double max_cut_within(double tolerance, double turn, bool smooth) {
    return turn >= kChangeTolerance ? tolerance / (corner_distance_share(smooth) * turn) : kUnlimited;
}

double largest_cut(const PlannerSetup& setup, const Block& from, const Block& to,
                   const DirectionChangeNorms& norms, bool smooth) {
    const rrs::CornerRules& corners = setup.controller.corners;
    const bool programmed = from.move.mode == rrs::PathMode::continuous && from.move.tolerance_mm > 0;
    const double tolerance_mm = programmed ? from.move.tolerance_mm : corners.blend_tolerance_mm;
    return std::min({kMaxCutShare * from.master.length, kMaxCutShare * to.master.length,
                     max_cut_within(tolerance_mm, norms.prismatic, smooth),
                     max_cut_within(corners.blend_tolerance_deg * kRadPerDeg, norms.rotary, smooth)});
}

/// Ramps that both blocks can do, up and down.
struct CommonRamp {
    CommonRamp(const Block& from, const Block& to)
        : acceleration(std::min({from.acceleration, from.deceleration, to.acceleration, to.deceleration})),
          jerk(std::min(from.jerk, to.jerk)) {}

    double acceleration;
    double jerk;
};

}  // namespace

BlendedCorner blend_between(const PlannerSetup& setup, const Block& from, const Block& to, bool smooth,
                            double speed_cap) {
    const rrs::JointPos turn = to.slope_in - from.slope_out;
    const DirectionChangeNorms norms = direction_change_norms(setup, from.master.role, turn);
    const double largest = largest_cut(setup, from, to, norms, smooth);
    if (!(largest > kCutTolerance)) return {};
    const BlendSpeedLimits turns(setup, from, to, turn, norms);
    BlendedCorner corner;
    corner.speed = std::min(speed_cap, turns.speed(largest, smooth));
    if (!std::isfinite(corner.speed)) return corner;
    const double cut = corner.speed < speed_cap ? largest : std::min(largest, turns.cut(speed_cap, smooth));
    if (!(cut > kCutTolerance)) return corner;
    corner.blend = {cut, smooth, corner_distance_share(smooth) * cut * read_position(setup, turn).norm()};
    return corner;
}

bool saves_time(const BlendedCorner& blended, double exact_speed, const Block& from, const Block& to,
                double speed_cap) {
    if (exact_speed >= blended.speed) return false;
    const auto [acceleration, jerk] = CommonRamp(from, to);
    const double cut = blended.blend.cut;
    const double available_length = std::min(from.master.length, to.master.length) / 2;
    const double reached =
        reachable_speed(std::max(available_length - cut, 0.0), blended.speed, acceleration, jerk);
    const double speed = std::min(speed_cap, reached);
    const double distance = ramp_length(exact_speed, speed, acceleration, jerk);
    const double blended_distance = cut + ramp_length(blended.speed, speed, acceleration, jerk);
    const double time_s = ramp_s(exact_speed, speed, acceleration, jerk);
    const double blended_time_s = cut / blended.speed + ramp_s(blended.speed, speed, acceleration, jerk);
    return blended_time_s < time_s + (blended_distance - distance) / speed;
}

Blend blend_at(const PlannerSetup& setup, const Block& from, const Block& to, double speed) {
    const Blend& planned = to.entry_blend;
    const rrs::JointPos turn = to.slope_in - from.slope_out;
    const BlendSpeedLimits turns(setup, from, to, turn,
                                 direction_change_norms(setup, from.master.role, turn));
    const double cut = turns.cut(speed, planned.smooth);
    if (!(cut < planned.cut)) return planned;
    return {std::max(cut, kCutTolerance), planned.smooth, planned.deviation_mm * cut / planned.cut};
}

double min_blend_speed(const Block& from, const Block& to) {
    constexpr double kMinBlendSpeedShare = 0.45;  // blends at joint limits are passed at half of it at least
    const auto [acceleration, jerk] = CommonRamp(from, to);
    return kMinBlendSpeedShare * reachable_speed(to.entry_blend.cut, 0, acceleration, jerk);
}

}  // namespace gsim::motion
