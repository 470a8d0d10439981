#include "motion/lookahead/corner.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "motion/lookahead/blend.h"
#include "motion/lookahead/corner_window.h"
#include "motion/path/axis_space.h"

namespace gsim::motion {

namespace {

constexpr double kStraight = 1e-9;  // difference of slopes that counts as none

using rrs::CornerRule;

double velocity_step_speed(const PlannerSetup& setup, const rrs::JointPos& turn) {
    double speed = kUnlimited;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double change = std::abs(turn[joint]);
        if (change >= kStraight) speed = std::min(speed, speed_step(setup, joint) / change);
    }
    return speed;
}

/// Returns the part of a joint slope that counts for the angle between two paths: that of the position
/// joints, or of all, with a degree as a millimetre.
rrs::JointPos direction_of(const PlannerSetup& setup, const rrs::JointPos& slope) {
    const bool of_all_axes = setup.controller.path_measure == rrs::PathMeasure::all_axes;
    rrs::JointPos direction = slope;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const JointRole role = setup.role(joint);
        if (role == JointRole::rotary) direction[joint] /= kRadPerDeg;
        if (role != JointRole::position && !of_all_axes) direction[joint] = 0;
    }
    return direction;
}

/// Returns the largest acceleration along a direction that the joints allow.
double acceleration_along(const PlannerSetup& setup, const rrs::JointPos& direction) {
    double acceleration = kUnlimited;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double share = std::abs(direction[joint]);
        if (share < kStraight) continue;
        const double limit = setup.joints[static_cast<std::size_t>(joint)].least_acceleration();
        const double unit = setup.role(joint) == JointRole::rotary ? kRadPerDeg : 1;
        acceleration = std::min(acceleration, limit / unit / share);
    }
    return acceleration;
}

/// Treats the corner as an arc which touches both paths and misses the corner by the deviation: v^2 = a r
/// with r = deviation sin(h) / (1 - sin(h)), h half of the angle between the paths (grbl 1.1). The thresholds
/// are grbl's.
double junction_deviation_speed(const PlannerSetup& setup, const Block& from, const Block& to) {
    constexpr double kStraightOn = -0.999999;
    constexpr double kBack = 0.999999;
    const rrs::JointPos in = direction_of(setup, from.slope_out);
    const rrs::JointPos out = direction_of(setup, to.slope_in);
    const double cosine = -in.dot(out);
    if (cosine < kStraightOn) return kUnlimited;
    if (cosine > kBack) return 0;
    const double half_sine = std::sqrt((1 - cosine) / 2);
    const double acceleration = acceleration_along(setup, (out - in).normalized());
    if (setup.controller.junction_deviation_mm <= 0) return 0;
    return std::sqrt(acceleration * setup.controller.junction_deviation_mm * half_sine / (1 - half_sine));
}

/// Rotary and other joints have no position on an arc in space, so junction deviation stops if their slope
/// changes.
bool only_position_turns(const PlannerSetup& setup, const rrs::JointPos& turn) {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (setup.role(joint) != JointRole::position && std::abs(turn[joint]) >= kStraight) return false;
    }
    return true;
}

CornerRule rule_at_end(const rrs::ControllerRules& controller, const Block& block) {
    return block.move.mode == rrs::PathMode::continuous ? controller.corner : controller.exact_path_corner;
}

/// True if all joints move in proportion, and the path is theirs.
bool is_straight(const Block& block) {
    return block.move.kind == SegmentKind::linear && !block.move.orientation && !block.move.piece;
}

/// Blends are between lines. The jumps of the joint speeds count if the joints' paths are not the tool's.
CornerRule rule_between(const rrs::ControllerRules& controller, const Block& from, const Block& to) {
    const CornerRule rule = rule_at_end(controller, from);
    if (rule != CornerRule::stop && (from.move.piece || to.move.piece)) return CornerRule::velocity_step;
    if (!is_blend(rule) || (is_straight(from) && is_straight(to))) return rule;
    return is_blend(controller.exact_path_corner) ? CornerRule::stop : controller.exact_path_corner;
}

/// Passes the corner at the end of `before` exactly, by a jump of the joint speeds.
BlendedCorner pass_by_jump(const PlannerSetup& setup, const BlocksBefore& before, const Block& to,
                           double most) {
    const double jump = velocity_step_speed(setup, to.slope_in - before.back().slope_out);
    const WindowSpeed in_window = speed_in_window(setup, before, std::min(most, jump), to);
    return {{}, in_window.speed, in_window.steps_cover};
}

/// Cuts nothing off if a jump takes no more time than a blend, as between the many lines that approximate a
/// curve.
BlendedCorner pass_by_blend(const PlannerSetup& setup, const BlocksBefore& before, const Block& to,
                            double most, bool smooth) {
    const BlendedCorner blended = blend_between(setup, before.back(), to, smooth, most);
    if (setup.controller.exact_path_corner != CornerRule::velocity_step) return blended;
    const BlendedCorner exact = pass_by_jump(setup, before, to, most);
    return saves_time(blended, exact.speed, before.back(), to, most) ? blended : exact;
}

bool jumps_where_exact(const rrs::ControllerRules& controller, const Block& from, const Block& to) {
    const CornerRule rule = rule_between(controller, from, to);
    return (is_blend(rule) ? controller.exact_path_corner : rule) == CornerRule::velocity_step;
}

BlendedCorner pass_by_rule(const PlannerSetup& setup, const BlocksBefore& before, const Block& to,
                           double most) {
    const Block& from = before.back();
    const rrs::JointPos turn = to.slope_in - from.slope_out;
    if ((turn.array().abs() < kStraight).all()) return {{}, kUnlimited, false};
    const CornerRule rule = rule_between(setup.controller, from, to);
    switch (rule) {
        case CornerRule::stop: return {};
        case CornerRule::velocity_step: return pass_by_jump(setup, before, to, most);
        case CornerRule::parabolic_blend:
        case CornerRule::smooth_blend:
            return pass_by_blend(setup, before, to, most, rule == CornerRule::smooth_blend);
        case CornerRule::junction_deviation: break;
    }
    const bool of_all_axes = setup.controller.path_measure == rrs::PathMeasure::all_axes;
    if (from.lead.role != JointRole::position || (!of_all_axes && !only_position_turns(setup, turn)))
        return {};
    return {{}, junction_deviation_speed(setup, from, to), false};
}

}  // namespace

double speed_step(const PlannerSetup& setup, int joint) {
    const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
    if (std::isfinite(limits.max_speed_step)) return limits.max_speed_step;
    return limits.least_acceleration() * setup.controller.speed_step_s;
}

CornerSpeed corner_speed(const PlannerSetup& setup, const BlocksBefore& before, const Block& to) {
    const Block& from = before.back();
    const rrs::ControllerRules& controller = setup.controller;
    const double most = std::min(from.max_speed, to.max_speed);
    if (from.move.piece && !from.move.reaches_target) return {most, LimitKind::feed, {}};
    const bool changes_mode = controller.stop_between_rapid_and_feed && from.move.rapid != to.move.rapid;
    if (changes_mode || from.lead.role != to.lead.role || from.move.mode == rrs::PathMode::exact_stop)
        return {};
    const BlendedCorner corner = pass_by_rule(setup, before, to, most);
    if (corner.speed == 0) return {};
    const bool takes =
        corner.blend.cut <= 0 && !corner.steps_cover && jumps_where_exact(controller, from, to);
    if (corner.speed < most) return {corner.speed, LimitKind::corner, corner.blend, takes};
    return {most, LimitKind::feed, corner.blend, takes};
}

double largest_exit_cut(const PlannerSetup& setup, const Block& block) {
    const bool rounded = is_straight(block) && block.move.mode != rrs::PathMode::exact_stop &&
                         is_blend(rule_at_end(setup.controller, block));
    return rounded ? kMostOfLine * block.lead.length : 0;
}

}  // namespace gsim::motion
