#include "motion/lookahead/block.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/units.h"
#include "motion/exact_stop/line_move.h"
#include "motion/path/arc_limits.h"
#include "motion/path/axis_space.h"
#include "motion/path/joint_changes.h"
#include "motion/path/master_path.h"
#include "motion/path/orientation_path.h"
#include "motion/profile/stepped_ramps.h"

namespace gsim::motion {

namespace {

/// Returns the largest change of each joint per path length, all along the path; 0 for the joints of an
/// orientation arc.
rrs::JointPos joint_shares(const PathMove& move, const PlannerSetup& setup, const Block& block) {
    rrs::JointPos shares = block.slope_in.cwiseAbs();
    if (move.orientation) shares[move.orientation->turn_joint()] = shares[move.orientation->tilt_joint()] = 0;
    if (move.kind != SegmentKind::circular) return shares;
    const Eigen::Vector3d arc_shares = move.arc.max_shares();
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        if (joint >= 0) shares[joint] = arc_shares[axis];
    }
    return shares;
}

void limit(double& value, LimitCause& by, double other, LimitCause other_by) {
    if (other >= value) return;
    value = other;
    by = other_by;
}

void limit_by_joints(const PlannerSetup& setup, const rrs::JointPos& shares, Block& block) {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double share = shares[joint];
        if (share < kMinShare) continue;
        const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
        const auto index = static_cast<std::int8_t>(joint);
        limit(block.max_speed, block.speed_limit, limits.max_speed / share, {LimitKind::joint_speed, index});
        limit(block.acceleration, block.acceleration_limit, limits.max_acceleration / share,
              {LimitKind::acceleration, index});
        block.deceleration = std::min(block.deceleration, limits.deceleration() / share);
        if (setup.controller.ramps.limit_jerk)
            limit(block.jerk, block.jerk_limit, limits.max_jerk / share, {LimitKind::jerk, index});
    }
}

/// Returns how far the joints other than the rotary ones move, mm.
double linear_distance(const JointChanges& changes) {
    return std::hypot(changes.norm(JointRole::position), changes.norm(JointRole::secondary));
}

/// True if only rotary joints move.
bool is_rotary_only(const JointChanges& changes) {
    return linear_distance(changes) == 0;
}

/// Returns the programmed speed along the master axes: of the tool, or of orientation if only rotary joints
/// move. It is converted if the measure is of all axes.
double programmed_speed(const PathMove& move, const MoveRules& rules, const JointChanges& changes,
                        const Block& block, const rrs::BlockRules& blocks) {
    if (rules.min_duration_s > 0) return block.master.length / rules.min_duration_s;
    if (block.master.role == JointRole::rotary) return rules.orientation_speed_rad_s;
    if (move.rapid) return kUnlimited;
    const bool measures_all_axes = blocks.path_measure == rrs::PathMeasure::all_axes;
    if (measures_all_axes && is_rotary_only(changes)) return rules.orientation_speed_rad_s / kRadPerDeg;
    const double feed = std::max(rules.programmed_speed_mm_s, blocks.min_feed_mm_min / 60);
    if (!measures_all_axes || blocks.feed_measure == rrs::PathMeasure::all_axes) return feed;
    return feed * block.master.length / linear_distance(changes);
}

/// Returns how far the tool turns: along the great circle, or by the norm of the rotary joints.
double rotation_angle(const PathMove& move, const JointChanges& changes) {
    return move.orientation ? move.orientation->length_rad() : changes.norm(JointRole::rotary);
}

void limit_by_program(const PathMove& move, const MoveRules& requested, const PlannerSetup& setup,
                      const JointChanges& changes, Block& block) {
    const double turn = rotation_angle(move, changes);
    const MoveRules rules = requested.with_dominance(turn > 0 && block.master.role != JointRole::rotary);
    limit(block.max_speed, block.speed_limit,
          programmed_speed(move, requested, changes, block, setup.controller.blocks),
          {requested.min_duration_s > 0 ? LimitKind::time : LimitKind::feed, -1});
    if (block.master.role != JointRole::rotary) {
        limit(block.max_speed, block.speed_limit, rules.max_path_speed_mm_s, {LimitKind::path_speed, -1});
        limit(block.acceleration, block.acceleration_limit, rules.path_acceleration_mm_s2,
              {LimitKind::path_acceleration, -1});
        block.deceleration = std::min(block.deceleration, rules.path_acceleration_mm_s2);
    }
    if (turn == 0) return;
    const double distance_per_rad = block.master.length / turn;
    limit(block.max_speed, block.speed_limit, rules.orientation_speed_rad_s * distance_per_rad,
          {LimitKind::feed, -1});
    limit(block.acceleration, block.acceleration_limit,
          rules.orientation_acceleration_rad_s2 * distance_per_rad, {LimitKind::path_acceleration, -1});
    block.deceleration =
        std::min(block.deceleration, rules.orientation_acceleration_rad_s2 * distance_per_rad);
}

/// Returns the acceleration that the joints can do towards the centre of an arc, all round it.
double acceleration_in_plane(const PlannerSetup& setup, const Arc& arc) {
    double acceleration = kUnlimited;
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        const double share = std::hypot(arc.u[axis], arc.v[axis]);
        if (joint < 0 || share < kMinShare) continue;
        acceleration =
            std::min(acceleration, setup.joints[static_cast<std::size_t>(joint)].min_acceleration() / share);
    }
    return acceleration;
}

/// Passes the limits of the block to `limit` as those of a MasterPath.
template <typename Limit>
void limit_master(Block& block, const Limit& limit) {
    MasterPath master{block.master.length, block.limits(), block.speed_limit, block.acceleration_limit,
                      block.jerk_limit};
    limit(master);
    block.max_speed = master.limits.max_speed;
    block.acceleration = master.limits.acceleration;
    block.deceleration = master.limits.deceleration;
    block.jerk = master.limits.jerk;
    block.speed_limit = master.speed_limit;
    block.acceleration_limit = master.acceleration_limit;
    block.jerk_limit = master.jerk_limit;
}

/// The acceleration of a joint is shared on a curve: one part keeps to the curve, the other one changes the
/// speed, at right angles to each other.
void limit_by_curvature(const PathMove& move, const PlannerSetup& setup, Block& block) {
    const double share = setup.controller.ramps.centripetal_share;
    if (!std::isfinite(share)) return;
    const double curvature = move.arc.max_curvature();
    const double centripetal_acceleration = share * acceleration_in_plane(setup, move.arc);
    limit(block.max_speed, block.speed_limit, std::sqrt(centripetal_acceleration / curvature),
          {LimitKind::centripetal, -1});
    if (share >= 1) return;
    block.acceleration *= std::sqrt(1 - share * share);
    block.deceleration *= std::sqrt(1 - share * share);
    limit_master(block, [&](MasterPath& master) { limit_by_oblique_helix(setup, move.arc, share, master); });
}

/// The joints follow the curve that the sub-segments of a move approximate. That may use half of what a joint
/// can do. The remainder at the speed of the block is for the ramps.
void limit_by_joint_curvature(const PlannerSetup& setup, const ToolSubSegment& sub_segment,
                              const rrs::JointPos& shares, Block& block) {
    constexpr double kMaxCurvatureShare = 0.5;
    const auto max_acceleration_of = [&](int joint) {
        return setup.joints[static_cast<std::size_t>(joint)].min_acceleration();
    };
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (sub_segment.joint_curvature[joint] > 0) {
            limit(block.max_speed, block.speed_limit,
                  std::sqrt(kMaxCurvatureShare * max_acceleration_of(joint) /
                            sub_segment.joint_curvature[joint]),
                  {LimitKind::centripetal, -1});
        }
    }
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (!(sub_segment.joint_curvature[joint] > 0) || shares[joint] < kMinShare ||
            std::isinf(max_acceleration_of(joint)))
            continue;
        const double remainder = max_acceleration_of(joint) -
                                 sub_segment.joint_curvature[joint] * block.max_speed * block.max_speed;
        limit(block.acceleration, block.acceleration_limit, remainder / shares[joint],
              {LimitKind::acceleration, static_cast<std::int8_t>(joint)});
        block.deceleration = std::min(block.deceleration, remainder / shares[joint]);
    }
}

MasterJoints make_master_joints(const PathMove& move, const JointChanges& changes,
                                const rrs::BlockRules& blocks) {
    if (blocks.path_measure == rrs::PathMeasure::all_axes && move.kind == SegmentKind::linear) {
        const double turn_deg = changes.norm(JointRole::rotary) / kRadPerDeg;
        return {JointRole::position, std::hypot(linear_distance(changes), turn_deg)};
    }
    if (move.sub_segment) return {move.sub_segment->role, move.sub_segment->length};
    if (move.kind == SegmentKind::circular) return {JointRole::position, move.arc.length_mm()};
    for (const JointRole role : {JointRole::position, JointRole::secondary}) {
        if (changes.norm(role) > 0) return {role, changes.norm(role)};
    }
    return {JointRole::rotary, rotation_angle(move, changes)};
}

void set_orientation_slopes(const OrientationArc& arc, Block& block) {
    const double rate = arc.length_rad() / block.master.length;
    const HeadAngles in = arc.at(0).first;
    const HeadAngles out = arc.at(arc.length_rad()).first;
    block.slope_in[arc.turn_joint()] = in.turn * rate;
    block.slope_in[arc.tilt_joint()] = in.tilt * rate;
    block.slope_out[arc.turn_joint()] = out.turn * rate;
    block.slope_out[arc.tilt_joint()] = out.tilt * rate;
}

void set_slopes(const PathMove& move, const PlannerSetup& setup, const JointChanges& changes, Block& block) {
    block.slope_in.resize(setup.joint_count());
    for (int joint = 0; joint < setup.joint_count(); ++joint)
        block.slope_in[joint] = changes.of(joint) / block.master.length;
    block.slope_out = block.slope_in;
    if (move.orientation) set_orientation_slopes(*move.orientation, block);
    if (move.kind != SegmentKind::circular) return;
    write_position(setup.position_joints, move.arc.tangent(0), block.slope_in);
    write_position(setup.position_joints, move.arc.tangent(move.arc.sweep_rad), block.slope_out);
}

void reserve_blend_acceleration(const rrs::RampRules& ramps, Block& block) {
    if (block.move.mode != rrs::PathMode::continuous) return;
    block.acceleration *= ramps.continuous_acceleration_share;
    block.deceleration *= ramps.continuous_acceleration_share;
}

/// Returns the path length of the tool; 0 if only rotary joints move.
double tool_path_length_mm(const MasterJoints& master, const JointChanges& changes,
                           const rrs::BlockRules& blocks) {
    if (master.role == JointRole::rotary) return 0;
    return blocks.path_measure == rrs::PathMeasure::all_axes ? linear_distance(changes) : master.length;
}

/// `requested` is the programmed speed, the only speed on which the mean acceleration depends.
void use_stepped_ramps(double requested, Block& block) {
    const double speed = std::isfinite(requested) ? requested : block.max_speed;
    const double acceleration = std::min(block.acceleration, block.deceleration);
    if (!std::isfinite(block.jerk) || !std::isfinite(acceleration) || !std::isfinite(speed)) return;
    block.steps = SteppedLimits{acceleration, block.jerk};
    block.acceleration = block.deceleration =
        SteppedRamps::mean_acceleration_s(speed, acceleration, block.jerk);
    block.acceleration_limit = block.jerk_limit;
    block.jerk = kUnlimited;
}

Settling make_settling(const rrs::PositionLoopRules& loop) {
    if (loop.gain_1_s <= 0) return {loop.settle_s, kUnlimited, kUnlimited};
    return {loop.settle_s, loop.in_position_mm, loop.in_position_deg * kRadPerDeg};
}

/// Returns an upper bound of the time from standstill to standstill.
double longest_s(const Block& block) {
    const double length = block.master.length;
    const double acceleration = std::min(block.acceleration, block.deceleration);
    return length / block.max_speed + 2 * std::sqrt(length / acceleration) +
           4 * std::cbrt(length / block.jerk);
}

PlanResult check(const Block& block) {
    if (!std::isfinite(block.master.length) || !(longest_s(block) <= kMaxDuration_s)) {
        return make_plan_error(
            rrs::Status::RRS_INVALID_PARAMETER,
            fmt::format("The move is too long or too slow: it would take more than {} s.", kMaxDuration_s));
    }
    if (!std::isfinite(block.max_speed) && !std::isfinite(block.acceleration)) {
        return make_plan_error(
            rrs::Status::RRS_ZERO_SPEED,
            "The move would take no time: no speed is programmed and the machine has no limit.");
    }
    return {};
}

}  // namespace

rrs::JointPos Block::line_at(double length) const {
    if (length <= 0) return move.start;
    if (length >= master.length) return move.end;
    return move.start + length / master.length * (move.end - move.start);
}

tl::expected<std::optional<Block>, PlanError> make_block(const PathMove& move, const PlannerSetup& setup,
                                                         const Overrides& overrides) {
    const JointChanges changes(setup, move.start, move.end);
    Block block;
    block.master = make_master_joints(move, changes, setup.controller.blocks);
    if (block.master.length == 0) return std::nullopt;
    const MoveRules rules = move.rules.with_overrides(overrides, move.enabled_overrides, move.rapid);
    const bool turns = block.master.role == JointRole::rotary || is_rotary_only(changes);
    const bool feed = !turns && !move.rapid && rules.min_duration_s <= 0;
    if (feed && rules.programmed_speed_mm_s <= 0) return no_programmed_speed_error();
    block.move = move;
    block.move.length_mm = tool_path_length_mm(block.master, changes, setup.controller.blocks);
    block.settling = make_settling(setup.controller.position_loop);
    set_slopes(move, setup, changes, block);
    limit_by_program(move, rules, setup, changes, block);
    limit_by_joints(setup, joint_shares(move, setup, block), block);
    if (move.sub_segment)
        limit_by_joint_curvature(setup, *move.sub_segment, block.slope_in.cwiseAbs(), block);
    if (move.kind == SegmentKind::circular) {
        limit_by_curvature(move, setup, block);
        limit_master(block, [&](MasterPath& master) { limit_by_arc_jerk(setup, move.arc, master); });
    }
    if (move.orientation)
        limit_master(block, [&](MasterPath& master) { limit_by_head(setup, *move.orientation, master); });
    reserve_blend_acceleration(setup.controller.ramps, block);
    if (setup.controller.blocks.time_s > 0) {
        limit(block.max_speed, block.speed_limit,
              block.master.length / (setup.controller.blocks.time_s * move.share),
              {LimitKind::block_time, -1});
    }
    if (rules.rapid_share < 1)
        limit(block.max_speed, block.speed_limit, rules.rapid_share * block.max_speed,
              {LimitKind::rapid_override, -1});
    if (setup.controller.ramps.limit_jerk && setup.controller.ramps.step_s > 0) {
        const double requested = programmed_speed(move, move.rules, changes, block, setup.controller.blocks);
        use_stepped_ramps(requested, block);
    }
    if (PlanResult checked = check(block); !checked) return tl::unexpected(std::move(checked.error()));
    return block;
}

}  // namespace gsim::motion
