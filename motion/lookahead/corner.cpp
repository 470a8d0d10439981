#include "motion/lookahead/corner.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "motion/lookahead/blend.h"
#include "motion/lookahead/corner_window.h"
#include "motion/path/axis_space.h"

namespace gsim::motion {

namespace {

constexpr double kSlopeTolerance = 1e-9;  // difference of slopes that counts as none

using rrs::CornerRule;

double velocity_step_speed(const PlannerSetup& setup, const rrs::JointPos& turn) {
    double speed = kUnlimited;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double change = std::abs(turn[joint]);
        if (change >= kSlopeTolerance) speed = std::min(speed, speed_step(setup, joint) / change);
    }
    return speed;
}

/// Returns the part of a joint slope that counts for the angle between two paths: that of the position
/// joints, or of all, with a degree as a millimetre.
rrs::JointPos unit_direction(const PlannerSetup& setup, const rrs::JointPos& slope) {
    const bool measures_all_axes = setup.controller.blocks.path_measure == rrs::PathMeasure::all_axes;
    rrs::JointPos direction = slope;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const JointRole role = setup.role(joint);
        if (role == JointRole::rotary) direction[joint] /= kRadPerDeg;
        if (role != JointRole::position && !measures_all_axes) direction[joint] = 0;
    }
    return direction;
}

/// Returns the largest acceleration along a direction that the joints allow.
double acceleration_along(const PlannerSetup& setup, const rrs::JointPos& direction) {
    double acceleration = kUnlimited;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double share = std::abs(direction[joint]);
        if (share < kSlopeTolerance) continue;
        const double limit = setup.joints[static_cast<std::size_t>(joint)].min_acceleration();
        const double unit = setup.role(joint) == JointRole::rotary ? kRadPerDeg : 1;
        acceleration = std::min(acceleration, limit / unit / share);
    }
    return acceleration;
}

/// Treats the corner as an arc which touches both paths and misses the corner by the deviation: v^2 = a r
/// with r = deviation sin(h) / (1 - sin(h)), h half of the angle between the paths (grbl 1.1). The thresholds
/// are grbl's.
double junction_deviation_speed(const PlannerSetup& setup, const Block& from, const Block& to) {
    constexpr double kStraightCosine = -0.999999;
    constexpr double kReversalCosine = 0.999999;
    const rrs::JointPos in = unit_direction(setup, from.slope_out);
    const rrs::JointPos out = unit_direction(setup, to.slope_in);
    const double cosine = -in.dot(out);
    if (cosine < kStraightCosine) return kUnlimited;
    if (cosine > kReversalCosine) return 0;
    const double half_sine = std::sqrt((1 - cosine) / 2);
    const double acceleration = acceleration_along(setup, (out - in).normalized());
    if (setup.controller.corners.junction_deviation_mm <= 0) return 0;
    return std::sqrt(acceleration * setup.controller.corners.junction_deviation_mm * half_sine /
                     (1 - half_sine));
}

/// Rotary and other joints have no position on an arc in space, so junction deviation stops if their slope
/// changes.
bool only_position_joints_turn(const PlannerSetup& setup, const rrs::JointPos& turn) {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (setup.role(joint) != JointRole::position && std::abs(turn[joint]) >= kSlopeTolerance)
            return false;
    }
    return true;
}

CornerRule rule_at_end(const rrs::CornerRules& corners, const Block& block) {
    return block.move.mode == rrs::PathMode::continuous ? corners.continuous : corners.exact_path;
}

/// True if all joints move in proportion, and the path is theirs.
bool is_straight(const Block& block) {
    return block.move.kind == SegmentKind::linear && !block.move.orientation && !block.move.sub_segment;
}

/// Blends are between lines. The jumps of the joint speeds count if the joints' paths are not the tool's.
CornerRule rule_between(const rrs::CornerRules& corners, const Block& from, const Block& to) {
    const CornerRule rule = rule_at_end(corners, from);
    if (rule != CornerRule::stop && (from.move.sub_segment || to.move.sub_segment))
        return CornerRule::velocity_step;
    if (!is_blend(rule) || (is_straight(from) && is_straight(to))) return rule;
    return is_blend(corners.exact_path) ? CornerRule::stop : corners.exact_path;
}

/// Passes the corner at the end of `before` exactly, by a jump of the joint speeds.
BlendedCorner pass_by_jump(const PlannerSetup& setup, const PrecedingBlocks& before, const Block& to,
                           double speed_cap) {
    const double jump = velocity_step_speed(setup, to.slope_in - before.back().slope_out);
    const WindowSpeed window_speed = speed_in_window(setup, before, std::min(speed_cap, jump), to);
    return {{}, window_speed.speed, window_speed.is_within_speed_steps};
}

/// Cuts nothing off if a jump takes no more time than a blend, as between the many lines that approximate a
/// curve.
BlendedCorner pass_by_blend(const PlannerSetup& setup, const PrecedingBlocks& before, const Block& to,
                            double speed_cap, bool smooth) {
    const BlendedCorner blended = blend_between(setup, before.back(), to, smooth, speed_cap);
    if (setup.controller.corners.exact_path != CornerRule::velocity_step) return blended;
    const BlendedCorner exact = pass_by_jump(setup, before, to, speed_cap);
    return saves_time(blended, exact.speed, before.back(), to, speed_cap) ? blended : exact;
}

bool uses_speed_jump(const rrs::CornerRules& corners, const Block& from, const Block& to) {
    const CornerRule rule = rule_between(corners, from, to);
    return (is_blend(rule) ? corners.exact_path : rule) == CornerRule::velocity_step;
}

BlendedCorner pass_by_rule(const PlannerSetup& setup, const PrecedingBlocks& before, const Block& to,
                           double speed_cap) {
    const Block& from = before.back();
    const rrs::JointPos turn = to.slope_in - from.slope_out;
    if ((turn.array().abs() < kSlopeTolerance).all()) return {{}, kUnlimited, false};
    const CornerRule rule = rule_between(setup.controller.corners, from, to);
    switch (rule) {
        case CornerRule::stop: return {};
        case CornerRule::velocity_step: return pass_by_jump(setup, before, to, speed_cap);
        case CornerRule::parabolic_blend:
        case CornerRule::smooth_blend:
            return pass_by_blend(setup, before, to, speed_cap, rule == CornerRule::smooth_blend);
        case CornerRule::junction_deviation: break;
    }
    const bool measures_all_axes = setup.controller.blocks.path_measure == rrs::PathMeasure::all_axes;
    if (from.master.role != JointRole::position ||
        (!measures_all_axes && !only_position_joints_turn(setup, turn)))
        return {};
    return {{}, junction_deviation_speed(setup, from, to), false};
}

}  // namespace

double speed_step(const PlannerSetup& setup, int joint) {
    const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
    if (std::isfinite(limits.max_speed_step)) return limits.max_speed_step;
    return limits.min_acceleration() * setup.controller.corners.speed_step_s;
}

CornerSpeed corner_speed(const PlannerSetup& setup, const PrecedingBlocks& before, const Block& to) {
    const Block& from = before.back();
    const rrs::CornerRules& corners = setup.controller.corners;
    const double speed_cap = std::min(from.max_speed, to.max_speed);
    if (from.move.sub_segment && !from.move.reaches_target) return {speed_cap, LimitKind::feed, {}};
    const bool changes_mode = corners.stop_between_rapid_and_feed && from.move.rapid != to.move.rapid;
    if (changes_mode || from.master.role != to.master.role || from.move.mode == rrs::PathMode::exact_stop)
        return {};
    const BlendedCorner corner = pass_by_rule(setup, before, to, speed_cap);
    if (corner.speed == 0) return {};
    const bool uses_acceleration =
        corner.blend.cut <= 0 && !corner.is_within_speed_steps && uses_speed_jump(corners, from, to);
    if (corner.speed < speed_cap) return {corner.speed, LimitKind::corner, corner.blend, uses_acceleration};
    return {speed_cap, LimitKind::feed, corner.blend, uses_acceleration};
}

double largest_exit_cut(const PlannerSetup& setup, const Block& block) {
    const bool rounded = is_straight(block) && block.move.mode != rrs::PathMode::exact_stop &&
                         is_blend(rule_at_end(setup.controller.corners, block));
    return rounded ? kMaxCutShare * block.master.length : 0;
}

}  // namespace gsim::motion
