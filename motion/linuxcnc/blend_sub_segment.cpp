#include "motion/linuxcnc/blend_sub_segment.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

namespace {

constexpr double kPlaneTolerance = 1e-6;
constexpr double kLengthTolerance_mm = 1e-9;
constexpr double kMinRemainderPeriods = 4;  // a shorter remainder of a line is no separate move
constexpr double kTangentTolerance = 0.25;  // of the acceleration across, for arcs that do not quite touch

bool parallel(const Vector3d& a, const Vector3d& b) {
    return 1 - std::abs(a.dot(b)) < kPlaneTolerance;
}

Vector3d normal_of(const SubSegment& arc) {
    return arc.arc.u.cross(arc.arc.v);
}

// A helix climbs out of its plane, so it makes no corner with a blend arc.
bool is_coplanar(const SubSegment& before, const SubSegment& after, const Corner& corner) {
    return (!before.curved || parallel(normal_of(before), corner.normal)) &&
           (!after.curved || parallel(normal_of(after), corner.normal));
}

Arc trim_end(const Arc& arc, double cut_rad) {
    return arc.part(0, arc.length_to(arc.sweep_rad - cut_rad));
}

Arc trim_start(const Arc& arc, double cut_rad) {
    return arc.part(arc.length_to(cut_rad), arc.length_mm());
}

Vector3d end_after_cut(const SubSegment& sub_segment, const Corner& corner, double cut) {
    return sub_segment.curved ? sub_segment.arc.at(sub_segment.arc.sweep_rad - cut)
                              : corner.point - cut * corner.in;
}

Vector3d start_after_cut(const SubSegment& sub_segment, const Corner& corner, double cut) {
    return sub_segment.curved ? sub_segment.arc.at(cut) : corner.point + cut * corner.out;
}

// Makes the shorter arc about the centre from one point to the other, which are equally far from it.
Arc arc_between(const Vector3d& center, const Vector3d& start, const Vector3d& end) {
    const Vector3d from = start - center, to = end - center;
    Arc arc;
    arc.center = center;
    arc.radius_mm = from.norm();
    arc.end_radius_mm = to.norm();
    if (std::abs(arc.end_radius_mm - arc.radius_mm) <= 1e-9) arc.end_radius_mm = arc.radius_mm;
    arc.u = from / arc.radius_mm;
    const Vector3d lateral = to - arc.u * arc.u.dot(to);
    arc.v = lateral.normalized();
    arc.sweep_rad = std::atan2(lateral.norm(), arc.u.dot(to));
    return arc;
}

// The angle of an arc has already been checked.
bool is_long_enough(const SubSegment& sub_segment, double cut) {
    return sub_segment.curved || cut <= sub_segment.length + kLengthTolerance_mm;
}

bool touches(const SubSegment& before, const SubSegment& after, const Blend& blend, const BlendSpeeds& speeds,
             double period_s) {
    const Arc& arc = blend.sub_segment.arc;
    const double allowed_speed_step =
        kNormalShare * kTangentTolerance * speeds.acceleration * period_s / speeds.speed;
    const auto off = [&](const Vector3d& a, const Vector3d& b) {
        return (a - b).norm() > allowed_speed_step;
    };
    if (before.curved && off(before.arc.tangent(before.arc.sweep_rad - blend.cut_before), arc.tangent(0))) {
        return false;
    }
    return !after.curved || !off(after.arc.tangent(blend.cut_after), arc.tangent(arc.sweep_rad));
}

void set_blend_limits(SubSegment& sub_segment, const SubSegment& before, const SubSegment& after,
                      const BlendSpeeds& speeds) {
    sub_segment.target_id = after.target_id;
    sub_segment.curved = true;
    sub_segment.rapid = before.rapid;
    sub_segment.junctions.end_condition = EndCondition::tangent;
    sub_segment.is_final = true;
    const bool exact =
        before.path_deviation == PathDeviation::no && after.path_deviation == PathDeviation::no;
    sub_segment.path_deviation = exact ? PathDeviation::corner : PathDeviation::other;
    sub_segment.limits.requested_speed = speeds.requested_speed;
    sub_segment.limits.max_speed = speeds.speed;
    sub_segment.limits.max_path_speed = std::min(before.limits.max_path_speed, after.limits.max_path_speed);
    sub_segment.limits.full_acceleration = speeds.acceleration;
    sub_segment.limits.jerk = std::min(before.limits.jerk, after.limits.jerk);
    sub_segment.limits.path_jerk = std::min(before.limits.path_jerk, after.limits.path_jerk);
    const bool is_slowed = speeds.speed < speeds.requested_speed;
    sub_segment.limits.speed_limit =
        is_slowed ? LimitCause{LimitKind::centripetal, -1} : before.limits.speed_limit;
    sub_segment.limits.acceleration_limit = {LimitKind::centripetal, -1};
}

// A short remainder of a line that would be no separate move becomes part of the blend.
void absorb_line_remainder(Blend& blend, const SubSegment& before, double period_s) {
    const double remainder = before.length - blend.cut_before;
    if (before.curved || before.junctions.after_parabola) return;
    if (remainder / blend.sub_segment.limits.max_speed >= kMinRemainderPeriods * period_s) return;
    blend.absorbs_previous_line = true;
    blend.sub_segment.start = before.start;
    blend.sub_segment.lead_in.length = remainder > kLengthTolerance_mm ? remainder : 0;
    blend.sub_segment.lead_in.target_id = before.target_id;
    blend.sub_segment.direction = before.direction;
}

}  // namespace

std::optional<Blend> blend_between(const SubSegment& before, const SubSegment& after, const Corner& corner,
                                   const Axes& axes, const PlanningRules& planning) {
    if (!is_coplanar(before, after, corner)) return std::nullopt;
    const Leg in = leg_before(before, corner), out = leg_after(after, corner);
    const auto speeds = blend_speeds(before, after, corner, in, out, axes);
    if (!speeds) return std::nullopt;
    const auto circle = blend_circle(corner, in, out, *speeds);
    if (!circle || !is_long_enough(before, circle->cut_before) || !is_long_enough(after, circle->cut_after))
        return std::nullopt;
    std::optional<Blend> blend(std::in_place);
    blend->cut_before = circle->cut_before;
    blend->cut_after = circle->cut_after;
    SubSegment& sub_segment = blend->sub_segment;
    set_blend_limits(sub_segment, before, after, *speeds);
    const Vector3d start = end_after_cut(before, corner, circle->cut_before);
    const Vector3d end = start_after_cut(after, corner, circle->cut_after);
    sub_segment.arc = arc_between(circle->center, start, end);
    sub_segment.deviation_mm =
        std::max((circle->center - corner.point).norm() - sub_segment.arc.radius_mm, 0.0);
    if (!(sub_segment.arc.sweep_rad > 0)) return std::nullopt;
    if (!touches(before, after, *blend, *speeds, planning.period_s)) return std::nullopt;
    sub_segment.start = sub_segment.end = before.end;
    axes.set_point(start, sub_segment.start);
    axes.set_point(end, sub_segment.end);
    absorb_line_remainder(*blend, before, planning.period_s);
    sub_segment.length = sub_segment.arc.radius_mm * sub_segment.arc.sweep_rad + sub_segment.lead_in.length;
    sub_segment.nominal_length = sub_segment.length;
    sub_segment.junctions.after_tangent = !blend->absorbs_previous_line || before.junctions.after_tangent;
    if (planning.since_2_10) {
        sub_segment.limits.max_speed =
            std::min(sub_segment.limits.max_speed, sub_segment.length / planning.period_s);
        limit_on_arc(sub_segment, planning);
    }
    const double min_periods = sub_segment.junctions.after_tangent ? kMinPeriods : 1;
    sub_segment.limits.max_speed =
        std::min(sub_segment.limits.max_speed, sub_segment.length / (min_periods * planning.period_s));
    return blend;
}

void trim_for_blend(const Blend& blend, const Axes& axes, SubSegment& before, SubSegment& after) {
    if (before.curved) {
        before.arc = trim_end(before.arc, blend.cut_before);
        before.length = timed_arc_length(before.arc);
    } else {
        before.length -= blend.cut_before;
    }
    axes.set_point(blend.sub_segment.arc.at(0), before.end);
    if (after.curved) {
        after.arc = trim_start(after.arc, blend.cut_after);
        after.length = timed_arc_length(after.arc);
    } else {
        after.length -= blend.cut_after;
    }
    after.start = blend.sub_segment.end;
}

}  // namespace gsim::motion::linuxcnc
