#include "motion/klipper/queued_move.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "motion/exact_stop/line_move.h"
#include "motion/path/joint_changes.h"
#include "motion/path/lead_path.h"

namespace gsim::motion::klipper {

namespace {

JointRole lead_role(const JointChanges& changes) {
    for (const JointRole role : {JointRole::position, JointRole::secondary}) {
        if (changes.norm(role) > 0) return role;
    }
    return JointRole::rotary;
}

/// Klipper measures a move of only extruders by the one that moves farthest.
double length_of(const PlannerSetup& setup, const JointChanges& changes, JointRole lead) {
    if (lead != JointRole::secondary) return changes.norm(lead);
    double length = 0;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        if (changes.role(joint) == lead) length = std::max(length, std::abs(changes.of(joint)));
    }
    return length;
}

/// An extruder's own limits apply to retraction, and to extrusion while the tool does not move across. The
/// tool's speed determines what the extruder lays down along the path.
bool is_limited(const PlannerSetup& setup, const QueuedMove& move, int joint) {
    if (setup.role(joint) != JointRole::secondary || move.slope[joint] < 0) return true;
    const auto moves = [&](int axis) {
        const int carrier = setup.position_joints[static_cast<std::size_t>(axis)];
        return carrier >= 0 && move.slope[carrier] != 0;
    };
    return !moves(0) && !moves(1);
}

void limit_by_joints(const PlannerSetup& setup, QueuedMove& move, LeadPath& lead) {
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double share = std::abs(move.slope[joint]);
        if (share == 0 || !is_limited(setup, move, joint)) continue;
        const JointSetup& of_joint = setup.joints[static_cast<std::size_t>(joint)];
        const double acceleration = of_joint.least_acceleration();
        lead.limit_by_joint(joint, {of_joint.max_speed, acceleration, acceleration, kUnlimited}, share);
    }
}

/// Klipper treats G0 like G1, so the path limits also apply to rapids.
double path_acceleration(const PlannerSetup& setup, const PathMove& line) {
    return std::min(line.rules.path_acceleration_mm_s2, setup.path.max_acceleration_mm_s2);
}

void limit_by_program(const PlannerSetup& setup, const PathMove& line, JointRole role, LeadPath& lead) {
    const MoveRules& rules = line.rules;
    if (rules.least_duration_s > 0) {
        lead.limit_speed(lead.length / rules.least_duration_s, {LimitKind::time, -1});
    } else if (role == JointRole::rotary) {
        lead.limit_speed(rules.orientation_speed_rad_s, {LimitKind::feed, -1});
    } else if (!line.rapid) {
        lead.limit_speed(rules.programmed_speed_mm_s, {LimitKind::feed, -1});
    }
    if (role != JointRole::position) return;
    lead.limit_speed(std::min(rules.max_path_speed_mm_s, setup.path.max_feed_mm_s),
                     {LimitKind::path_speed, -1});
    lead.limit_acceleration(path_acceleration(setup, line), {LimitKind::path_acceleration, -1});
}

void set_plans(const PlannerSetup& setup, const PathMove& line, QueuedMove& move) {
    const double path = path_acceleration(setup, line);
    const double whole = std::isfinite(path) ? path : move.acceleration;
    const double corner = setup.controller.square_corner_velocity_mm_s;
    move.junction_deviation_mm = corner * corner * (std::numbers::sqrt2 - 1) / whole;
    const double smooth = std::min(whole * (1 - setup.controller.minimum_cruise_ratio), move.acceleration);
    move.full.change = 2 * move.length * move.acceleration;
    move.smooth.change = 2 * move.length * smooth;
}

bool has_speed(const PathMove& line, JointRole role) {
    if (line.rapid || line.rules.least_duration_s > 0) return true;
    return (role == JointRole::rotary ? line.rules.orientation_speed_rad_s
                                      : line.rules.programmed_speed_mm_s) > 0;
}

Planned check(const QueuedMove& move) {
    const double longest_s = move.length / move.max_speed + 2 * std::sqrt(move.length / move.acceleration);
    if (!std::isfinite(move.length) || !(longest_s <= kLongest_s)) {
        return refused(
            rrs::Status::RRS_INVALID_PARAMETER,
            fmt::format("The move is too long or too slow: it would take more than {} s.", kLongest_s));
    }
    if (!std::isfinite(move.max_speed) || !std::isfinite(move.acceleration)) {
        return refused(rrs::Status::RRS_ZERO_SPEED,
                       "This controller plans no move without limits: neither the path nor an axis of it has "
                       "a greatest speed and a greatest acceleration.");
    }
    return {};
}

}  // namespace

tl::expected<QueuedMove, PlanError> queued_move(const PlannerSetup& setup, const PathMove& line) {
    const JointChanges changes(setup, line.start, line.end);
    const JointRole role = lead_role(changes);
    QueuedMove move;
    move.target_id = line.target_id;
    move.reaches_target = line.reaches_target;
    move.start = line.start;
    move.end = line.end;
    move.length = length_of(setup, changes, role);
    if (move.length == 0) return move;
    if (!has_speed(line, role)) return no_programmed_speed();
    move.moves_tool = role == JointRole::position;
    move.length_mm = role == JointRole::rotary ? 0 : move.length;
    move.stops = line.mode == rrs::PathMode::exact_stop;
    move.slope.resize(setup.joint_count());
    for (int joint = 0; joint < setup.joint_count(); ++joint)
        move.slope[joint] = changes.of(joint) / move.length;
    LeadPath lead{.length = move.length};
    limit_by_program(setup, line, role, lead);
    limit_by_joints(setup, move, lead);
    move.max_speed = lead.limits.max_speed;
    move.acceleration = lead.limits.acceleration;
    move.speed_limit = lead.speed_limit;
    move.acceleration_limit = lead.acceleration_limit;
    if (Planned checked = check(move); !checked) return tl::unexpected(std::move(checked.error()));
    set_plans(setup, line, move);
    return move;
}

}  // namespace gsim::motion::klipper
