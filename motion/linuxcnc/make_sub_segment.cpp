#include "motion/linuxcnc/make_sub_segment.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "motion/exact_stop/line_move.h"
#include "motion/path/joint_changes.h"
#include "motion/path/master_path.h"

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

namespace {

constexpr double kMinChange = 1e-7;      // LinuxCNC makes no move of less
constexpr double kMinPlaneShare = 1e-9;  // share of an axis in a plane below which the plane lies across it

JointRole sub_segment_role(const JointChanges& changes, bool curved) {
    if (curved || changes.norm(JointRole::position) > 0) return JointRole::position;
    return changes.norm(JointRole::secondary) > 0 ? JointRole::secondary : JointRole::rotary;
}

// Largest change of a joint divided by its limit, and the joint that has it.
struct LimitRatio {
    double value = 0;
    int joint = -1;

    void raise(double other, int by) {
        if (other > value) *this = {other, by};
    }
    // Returns the limit along a path of `length`; unlimited if no joint needs one.
    double along(double length) const { return value > 0 ? length / value : kUnlimited; }
};

struct JointLimitRatios {
    LimitRatio speed;
    LimitRatio acceleration;
    LimitRatio jerk;
    bool has_unlimited_jerk = false;  // a joint has no jerk limit
};

// LinuxCNC uses only the jerks of X, Y and Z round an arc.
JointLimitRatios joint_limit_ratios(const PlannerSetup& setup, const JointChanges& changes, bool curved) {
    JointLimitRatios demands;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double change = std::abs(changes.of(joint));
        if (change == 0) continue;
        const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
        demands.speed.raise(change / limits.max_speed, joint);
        demands.acceleration.raise(change / limits.max_acceleration, joint);
        if (curved && setup.role(joint) != JointRole::position) continue;
        demands.jerk.raise(change / limits.max_jerk, joint);
        demands.has_unlimited_jerk |= std::isinf(limits.max_jerk);
    }
    return demands;
}

// Returns the limit of the slowest axis in the arc's plane.
double min_in_plane(const Vector3d& limits, const Arc& arc) {
    double min = kUnlimited;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::hypot(arc.u[axis], arc.v[axis]) > kMinPlaneShare) min = std::min(min, limits[axis]);
    }
    return min;
}

void limit_line(SubSegment& sub_segment, const JointLimitRatios& demands) {
    sub_segment.limits.max_speed = demands.speed.along(sub_segment.length);
    sub_segment.limits.full_acceleration = demands.acceleration.along(sub_segment.length);
}

// Returns the path length round an arc, by the smaller of its radii.
double arc_distance_mm(const Arc& arc) {
    const double radius_mm = std::min(arc.radius_mm, arc.end_radius_mm);
    return std::hypot(radius_mm * arc.sweep_rad, arc.end_radius_mm - arc.radius_mm);
}

// The chord counts for the joints, the path round the arc for the axes of its plane.
void limit_arc(SubSegment& sub_segment, const Axes& axes, JointLimitRatios& demands) {
    const Arc& arc = sub_segment.arc;
    const double acceleration = min_in_plane(axes.max_acceleration_mm_s2(), arc);
    const double change = arc.end_radius_mm - arc.radius_mm;
    const double radius_mm = std::min(arc.radius_mm, arc.end_radius_mm);
    const double arc_mm = arc_distance_mm(arc);
    const double bend_mm = std::hypot(change / arc.sweep_rad, radius_mm);
    const double centripetal_speed = std::sqrt(kNormalShare * acceleration * bend_mm);
    const double speed = std::min(centripetal_speed, min_in_plane(axes.max_speed_mm_s(), arc));
    if (centripetal_speed <= speed) sub_segment.limits.speed_limit = {LimitKind::centripetal, -1};
    demands.speed.raise(arc_mm / speed, -1);
    demands.acceleration.raise(arc_mm / acceleration, -1);
    demands.jerk.raise(arc_mm / min_in_plane(axes.max_jerk_mm_s3(), arc), -1);
    const double full_length_mm = std::hypot(arc_mm, arc.lift.norm());
    sub_segment.limits.max_speed = demands.speed.along(full_length_mm);
    sub_segment.limits.full_acceleration = demands.acceleration.along(full_length_mm);
}

double requested_speed_of(const PathMove& move, const SubSegment& sub_segment, JointRole role) {
    if (move.rapid) return kUnlimited;
    if (move.rules.min_duration_s > 0) return sub_segment.length / move.rules.min_duration_s;
    return role == JointRole::rotary ? move.rules.orientation_speed_rad_s : move.rules.programmed_speed_mm_s;
}

LimitCause joint_limit(LimitKind kind, int joint) {
    return {kind, static_cast<std::int8_t>(joint)};
}

void set_speeds(SubSegment& sub_segment, const PathMove& move, JointRole role,
                const JointLimitRatios& demands, double period_s) {
    const double limited_speed = requested_speed_of(move, sub_segment, role);
    if (sub_segment.limits.speed_limit.kind != LimitKind::centripetal || demands.speed.joint >= 0) {
        sub_segment.limits.speed_limit = joint_limit(LimitKind::joint_speed, demands.speed.joint);
    }
    if (limited_speed <= sub_segment.limits.max_speed) {
        sub_segment.limits.speed_limit = {move.rules.min_duration_s > 0 ? LimitKind::time : LimitKind::feed,
                                          -1};
    }
    sub_segment.limits.requested_speed = std::min(limited_speed, sub_segment.limits.max_speed);
    sub_segment.limits.path_limited = role != JointRole::rotary;
    sub_segment.limits.max_path_speed = move.rules.max_path_speed_mm_s;
    if (sub_segment.limits.path_limited &&
        sub_segment.limits.max_path_speed < sub_segment.limits.requested_speed) {
        sub_segment.limits.speed_limit = {LimitKind::path_speed, -1};
    }
    sub_segment.limits.max_speed = std::min(sub_segment.limits.max_speed, sub_segment.length / period_s);
}

void set_acceleration(SubSegment& sub_segment, const PathMove& move, JointRole role,
                      const JointLimitRatios& demands, double period_s) {
    sub_segment.limits.acceleration_limit = joint_limit(LimitKind::acceleration, demands.acceleration.joint);
    const double limit = role == JointRole::rotary ? move.rules.orientation_acceleration_rad_s2
                                                   : move.rules.path_acceleration_mm_s2;
    if (limit < sub_segment.limits.full_acceleration) {
        sub_segment.limits.full_acceleration = limit;
        sub_segment.limits.acceleration_limit = {LimitKind::path_acceleration, -1};
    }
    // The speed is reached within a period if no limit applies.
    if (!std::isfinite(sub_segment.limits.full_acceleration))
        sub_segment.limits.full_acceleration = sub_segment.limits.max_speed / period_s;
}

// One joint without a limit leaves the complete move without S-curves, as in LinuxCNC.
void set_jerk(SubSegment& sub_segment, JointRole role, const JointLimitRatios& demands,
              const PlanningRules& planning) {
    if (!planning.s_curves) return;
    sub_segment.limits.path_jerk = planning.path_jerk * (role == JointRole::rotary ? kRadPerDeg : 1);
    const double length = sub_segment.curved
                              ? std::hypot(arc_distance_mm(sub_segment.arc), sub_segment.arc.lift.norm())
                              : sub_segment.length;
    if (!demands.has_unlimited_jerk) sub_segment.limits.jerk = demands.jerk.along(length);
    if (std::isfinite(sub_segment.limits.jerk))
        sub_segment.limits.jerk = std::min(sub_segment.limits.jerk, sub_segment.limits.path_jerk);
}

EndCondition end_condition_of(rrs::PathMode mode) {
    switch (mode) {
        case rrs::PathMode::exact_path: return EndCondition::exact;
        case rrs::PathMode::continuous: return EndCondition::parabola;
        case rrs::PathMode::exact_stop: break;
    }
    return EndCondition::stop;
}

bool has_speed(const PathMove& move, JointRole role) {
    if (move.rapid || move.rules.min_duration_s > 0) return true;
    return role == JointRole::rotary ? move.rules.orientation_speed_rad_s > 0
                                     : move.rules.programmed_speed_mm_s > 0;
}

// Rejects values from which no sub-segment can be made.
PlanResult check_values(const PathMove& move, const SubSegment& sub_segment, JointRole role) {
    if (!move.start.allFinite() || !move.end.allFinite() || !(sub_segment.length < kUnlimited)) {
        return make_plan_error(rrs::Status::RRS_INVALID_PARAMETER,
                               "The move is too long, or does not lead to a position.");
    }
    if (sub_segment.length == 0) return {};
    if (!has_speed(move, role) || !(move.rules.max_path_speed_mm_s > 0)) return no_programmed_speed_error();
    return {};
}

PlanResult check_time(const SubSegment& sub_segment) {
    const double speed = target_speed(sub_segment);
    if (sub_segment.length == 0 ||
        sub_segment.length / speed + speed / sub_segment.limits.full_acceleration <= kMaxDuration_s)
        return {};
    return make_plan_error(
        rrs::Status::RRS_INVALID_PARAMETER,
        fmt::format("The move is too long or too slow: it would take more than {} s.", kMaxDuration_s));
}

void set_path(SubSegment& sub_segment, const Axes& axes, const PathMove& move, const JointChanges& changes,
              JointRole role) {
    sub_segment.target_id = move.target_id;
    sub_segment.curved = move.kind == SegmentKind::circular;
    sub_segment.rapid = move.rapid;
    sub_segment.enabled_overrides = move.enabled_overrides;
    sub_segment.follows_spindle = move.rules.follows_spindle && !move.rapid;
    sub_segment.turns = changes.norm(JointRole::secondary) > 0 || changes.norm(JointRole::rotary) > 0;
    sub_segment.start = move.start;
    sub_segment.end = move.end;
    sub_segment.length = sub_segment.curved ? timed_arc_length(move.arc) : changes.norm(role);
    sub_segment.nominal_length = sub_segment.length;
    if (sub_segment.curved) {
        sub_segment.arc = move.arc;
    } else if (role == JointRole::position) {
        sub_segment.direction = (axes.point(move.end) - axes.point(move.start)) / sub_segment.length;
    }
}

void set_limits(SubSegment& sub_segment, const PlannerSetup& setup, const Axes& axes, const PathMove& move,
                const JointChanges& changes, JointRole role, const PlanningRules& planning) {
    JointLimitRatios demands = joint_limit_ratios(setup, changes, sub_segment.curved);
    if (sub_segment.curved) {
        limit_arc(sub_segment, axes, demands);
    } else {
        limit_line(sub_segment, demands);
    }
    set_speeds(sub_segment, move, role, demands, planning.period_s);
    set_acceleration(sub_segment, move, role, demands, planning.period_s);
    sub_segment.junctions.end_condition = end_condition_of(move.mode);
    sub_segment.junctions.tolerance_mm = move.mode == rrs::PathMode::continuous ? move.tolerance_mm : 0;
    set_jerk(sub_segment, role, demands, planning);
    if (sub_segment.curved && planning.since_2_10) limit_on_arc(sub_segment, planning);
}

}  // namespace

bool certainly_moves(const PlannerSetup& setup, const PathMove& move) {
    if (move.kind == SegmentKind::circular || move.rapid || move.rules.min_duration_s > 0) return false;
    if (!move.start.allFinite() || !move.end.allFinite()) return false;
    const JointChanges changes(setup, move.start, move.end, kMinChange);
    if (changes.norm(JointRole::secondary) > 0 || changes.norm(JointRole::rotary) > 0) return false;
    const double length_mm = changes.norm(JointRole::position);
    const double requested_mm_s = move.rules.programmed_speed_mm_s;
    double speed_mm_s = std::min(requested_mm_s, move.rules.max_path_speed_mm_s);
    double acceleration_mm_s2 = move.rules.path_acceleration_mm_s2;
    for (const int joint : setup.position_joints) {
        if (joint < 0) continue;
        const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
        speed_mm_s = std::min(speed_mm_s, limits.max_speed);
        acceleration_mm_s2 = std::min(acceleration_mm_s2, limits.max_acceleration);
    }
    return length_mm > 0 && speed_mm_s > 0 &&
           length_mm / speed_mm_s + requested_mm_s / acceleration_mm_s2 <= kMaxDuration_s;
}

tl::expected<SubSegment, PlanError> make_sub_segment(const PlannerSetup& setup, const Axes& axes,
                                                     const PathMove& move, const PlanningRules& planning) {
    const JointChanges changes(setup, move.start, move.end, kMinChange);
    const JointRole role = sub_segment_role(changes, move.kind == SegmentKind::circular);
    SubSegment sub_segment;
    set_path(sub_segment, axes, move, changes, role);
    if (PlanResult values = check_values(move, sub_segment, role); !values)
        return tl::unexpected(values.error());
    if (sub_segment.length > 0) set_limits(sub_segment, setup, axes, move, changes, role, planning);
    if (PlanResult time = check_time(sub_segment); !time) return tl::unexpected(time.error());
    return sub_segment;
}

}  // namespace gsim::motion::linuxcnc
