#include "motion/klipper/queued_move.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "motion/exact_stop/line_move.h"
#include "motion/path/joint_changes.h"
#include "motion/path/master_path.h"

namespace gsim::motion::klipper {

namespace {

JointRole master_role(const JointChanges& changes) {
    for (const JointRole role : {JointRole::position, JointRole::secondary}) {
        if (changes.norm(role) > 0) return role;
    }
    return JointRole::rotary;
}

/// Klipper measures a move of only extruders by the one that moves farthest.
double move_length(const PlannerSetup& setup, const JointChanges& changes, JointRole master) {
    if (master != JointRole::secondary) return changes.norm(master);
    double length = 0;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (changes.role(joint) == master) length = std::max(length, std::abs(changes.of(joint)));
    }
    return length;
}

/// An extruder's own limits apply to retraction, and to extrusion while the tool does not move across. The
/// tool's speed determines what the extruder lays down along the path.
bool is_limited(const PlannerSetup& setup, const QueuedMove& move, int joint) {
    if (setup.role(joint) != JointRole::secondary || move.slope[joint] < 0) return true;
    const auto moves = [&](int axis) {
        const int axis_joint = setup.position_joints[static_cast<std::size_t>(axis)];
        return axis_joint >= 0 && move.slope[axis_joint] != 0;
    };
    return !moves(0) && !moves(1);
}

void limit_by_joints(const PlannerSetup& setup, QueuedMove& move, MasterPath& master) {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double share = std::abs(move.slope[joint]);
        if (share == 0 || !is_limited(setup, move, joint)) continue;
        const JointSetup& joint_limits = setup.joints[static_cast<std::size_t>(joint)];
        const double acceleration = joint_limits.min_acceleration();
        master.limit_by_joint(joint, {joint_limits.max_speed, acceleration, acceleration, kUnlimited}, share);
    }
}

/// Klipper treats G0 like G1, so the path limits also apply to rapids.
double path_acceleration(const PlannerSetup& setup, const PathMove& line) {
    return std::min(line.rules.path_acceleration_mm_s2, setup.path.max_acceleration_mm_s2);
}

void limit_by_program(const PlannerSetup& setup, const PathMove& line, JointRole role, MasterPath& master) {
    const MoveRules& rules = line.rules;
    if (rules.min_duration_s > 0) {
        master.limit_speed(master.length / rules.min_duration_s, {LimitKind::time, -1});
    } else if (role == JointRole::rotary) {
        master.limit_speed(rules.orientation_speed_rad_s, {LimitKind::feed, -1});
    } else if (!line.rapid) {
        master.limit_speed(rules.programmed_speed_mm_s, {LimitKind::feed, -1});
    }
    if (role != JointRole::position) return;
    master.limit_speed(std::min(rules.max_path_speed_mm_s, setup.path.max_feed_mm_s),
                       {LimitKind::path_speed, -1});
    master.limit_acceleration(path_acceleration(setup, line), {LimitKind::path_acceleration, -1});
}

void set_speed_plans(const PlannerSetup& setup, const PathMove& line, QueuedMove& move) {
    const double path = path_acceleration(setup, line);
    const double full_acceleration = std::isfinite(path) ? path : move.acceleration;
    const double corner = setup.controller.klipper.square_corner_velocity_mm_s;
    move.junction_deviation_mm = corner * corner * (std::numbers::sqrt2 - 1) / full_acceleration;
    const double smooth =
        std::min(full_acceleration * (1 - setup.controller.klipper.minimum_cruise_ratio), move.acceleration);
    move.full.change = 2 * move.length * move.acceleration;
    move.smooth.change = 2 * move.length * smooth;
}

bool has_speed(const PathMove& line, JointRole role) {
    if (line.rapid || line.rules.min_duration_s > 0) return true;
    return (role == JointRole::rotary ? line.rules.orientation_speed_rad_s
                                      : line.rules.programmed_speed_mm_s) > 0;
}

PlanResult check(const QueuedMove& move) {
    const double longest_s = move.length / move.max_speed + 2 * std::sqrt(move.length / move.acceleration);
    if (!std::isfinite(move.length) || !(longest_s <= kMaxDuration_s)) {
        return make_plan_error(
            rrs::Status::RRS_INVALID_PARAMETER,
            fmt::format("The move is too long or too slow: it would take more than {} s.", kMaxDuration_s));
    }
    if (!std::isfinite(move.max_speed) || !std::isfinite(move.acceleration)) {
        return make_plan_error(rrs::Status::RRS_ZERO_SPEED,
                               "This controller cannot plan a move without limits: neither the path nor any "
                               "of its axes has a max speed and a max acceleration.");
    }
    return {};
}

}  // namespace

tl::expected<QueuedMove, PlanError> queued_move(const PlannerSetup& setup, const PathMove& line) {
    const JointChanges changes(setup, line.start, line.end);
    const JointRole role = master_role(changes);
    QueuedMove move;
    move.target_id = line.target_id;
    move.reaches_target = line.reaches_target;
    move.start = line.start;
    move.end = line.end;
    move.length = move_length(setup, changes, role);
    if (move.length == 0) return move;
    if (!has_speed(line, role)) return no_programmed_speed_error();
    move.moves_tool = role == JointRole::position;
    move.length_mm = role == JointRole::rotary ? 0 : move.length;
    move.stops = line.mode == rrs::PathMode::exact_stop;
    move.slope.resize(setup.joint_count());
    for (int joint = 0; joint < setup.joint_count(); ++joint)
        move.slope[joint] = changes.of(joint) / move.length;
    MasterPath master{.length = move.length};
    limit_by_program(setup, line, role, master);
    limit_by_joints(setup, move, master);
    move.max_speed = master.limits.max_speed;
    move.acceleration = master.limits.acceleration;
    move.speed_limit = master.speed_limit;
    move.acceleration_limit = master.acceleration_limit;
    if (PlanResult checked = check(move); !checked) return tl::unexpected(std::move(checked.error()));
    set_speed_plans(setup, line, move);
    return move;
}

}  // namespace gsim::motion::klipper
