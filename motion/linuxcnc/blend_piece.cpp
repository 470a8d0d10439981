#include "motion/linuxcnc/blend_piece.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

namespace {

constexpr double kOnePlane = 1e-6;
constexpr double kNothing_mm = 1e-9;
constexpr double kGapPeriods = 4;       // a shorter remainder of a line is no separate move
constexpr double kTangentShare = 0.25;  // of the acceleration across, for arcs that do not quite touch

bool parallel(const Vector3d& a, const Vector3d& b) {
    return 1 - std::abs(a.dot(b)) < kOnePlane;
}

Vector3d normal_of(const Piece& arc) {
    return arc.arc.u.cross(arc.arc.v);
}

// A helix climbs out of its plane, so it makes no corner with a blend arc.
bool in_one_plane(const Piece& before, const Piece& after, const Corner& corner) {
    return (!before.curved || parallel(normal_of(before), corner.normal)) &&
           (!after.curved || parallel(normal_of(after), corner.normal));
}

Arc without_end(const Arc& arc, double cut_rad) {
    return arc.part(0, arc.length_to(arc.sweep_rad - cut_rad));
}

Arc without_begin(const Arc& arc, double cut_rad) {
    return arc.part(arc.length_to(cut_rad), arc.length_mm());
}

Vector3d end_after_cut(const Piece& piece, const Corner& corner, double cut) {
    return piece.curved ? piece.arc.at(piece.arc.sweep_rad - cut) : corner.point - cut * corner.in;
}

Vector3d start_after_cut(const Piece& piece, const Corner& corner, double cut) {
    return piece.curved ? piece.arc.at(cut) : corner.point + cut * corner.out;
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
    const Vector3d aside = to - arc.u * arc.u.dot(to);
    arc.v = aside.normalized();
    arc.sweep_rad = std::atan2(aside.norm(), arc.u.dot(to));
    return arc;
}

// The angle of an arc has already been checked.
bool fits(const Piece& piece, double cut) {
    return piece.curved || cut <= piece.length + kNothing_mm;
}

bool touches(const Piece& before, const Piece& after, const Blend& blend, const BlendSpeeds& speeds,
             double period_s) {
    const Arc& arc = blend.piece.arc;
    const double allowed = kNormalShare * kTangentShare * speeds.acceleration * period_s / speeds.speed;
    const auto off = [&](const Vector3d& a, const Vector3d& b) { return (a - b).norm() > allowed; };
    if (before.curved && off(before.arc.tangent(before.arc.sweep_rad - blend.cut_before), arc.tangent(0))) {
        return false;
    }
    return !after.curved || !off(after.arc.tangent(blend.cut_after), arc.tangent(arc.sweep_rad));
}

void set_blend_limits(Piece& piece, const Piece& before, const Piece& after, const BlendSpeeds& speeds) {
    piece.target_id = after.target_id;
    piece.curved = true;
    piece.rapid = before.rapid;
    piece.term = Term::tangent;
    piece.settled = true;
    const bool exact = before.off_way == OffWay::no && after.off_way == OffWay::no;
    piece.off_way = exact ? OffWay::corner : OffWay::yes;
    piece.requested_speed = speeds.requested_speed;
    piece.max_speed = speeds.speed;
    piece.max_path_speed = std::min(before.max_path_speed, after.max_path_speed);
    piece.full_acceleration = speeds.acceleration;
    piece.jerk = std::min(before.jerk, after.jerk);
    piece.path_jerk = std::min(before.path_jerk, after.path_jerk);
    const bool bent = speeds.speed < speeds.requested_speed;
    piece.speed_limit = bent ? LimitedBy{LimitKind::centripetal, -1} : before.speed_limit;
    piece.acceleration_limit = {LimitKind::centripetal, -1};
}

// A short remainder of a line that would be no separate move becomes part of the blend.
void take_rest_of_line(Blend& blend, const Piece& before, double period_s) {
    const double rest = before.length - blend.cut_before;
    if (before.curved || before.after_parabola) return;
    if (rest / blend.piece.max_speed >= kGapPeriods * period_s) return;
    blend.takes_before = true;
    blend.piece.start = before.start;
    blend.piece.lead_in = rest > kNothing_mm ? rest : 0;
    blend.piece.lead_in_id = before.target_id;
    blend.piece.direction = before.direction;
}

}  // namespace

std::optional<Blend> blend_between(const Piece& before, const Piece& after, const Corner& corner,
                                   const Axes& axes, const Planning& planning) {
    if (!in_one_plane(before, after, corner)) return std::nullopt;
    const Leg in = leg_before(before, corner), out = leg_after(after, corner);
    const auto speeds = blend_speeds(before, after, corner, in, out, axes);
    if (!speeds) return std::nullopt;
    const auto circle = blend_circle(corner, in, out, *speeds);
    if (!circle || !fits(before, circle->cut_before) || !fits(after, circle->cut_after)) return std::nullopt;
    std::optional<Blend> blend(std::in_place);
    blend->cut_before = circle->cut_before;
    blend->cut_after = circle->cut_after;
    Piece& piece = blend->piece;
    set_blend_limits(piece, before, after, *speeds);
    const Vector3d start = end_after_cut(before, corner, circle->cut_before);
    const Vector3d end = start_after_cut(after, corner, circle->cut_after);
    piece.arc = arc_between(circle->center, start, end);
    piece.deviation_mm = std::max((circle->center - corner.point).norm() - piece.arc.radius_mm, 0.0);
    if (!(piece.arc.sweep_rad > 0)) return std::nullopt;
    if (!touches(before, after, *blend, *speeds, planning.period_s)) return std::nullopt;
    piece.start = piece.end = before.end;
    axes.put(start, piece.start);
    axes.put(end, piece.end);
    take_rest_of_line(*blend, before, planning.period_s);
    piece.length = piece.arc.radius_mm * piece.arc.sweep_rad + piece.lead_in;
    piece.nominal_length = piece.length;
    piece.after_tangent = !blend->takes_before || before.after_tangent;
    if (planning.since_2_10) {
        piece.max_speed = std::min(piece.max_speed, piece.length / planning.period_s);
        limit_on_arc(piece, planning);
    }
    const double least_periods = piece.after_tangent ? kLeastPeriods : 1;
    piece.max_speed = std::min(piece.max_speed, piece.length / (least_periods * planning.period_s));
    return blend;
}

void make_room(const Blend& blend, const Axes& axes, Piece& before, Piece& after) {
    if (before.curved) {
        before.arc = without_end(before.arc, blend.cut_before);
        before.length = way_length(before.arc);
    } else {
        before.length -= blend.cut_before;
    }
    axes.put(blend.piece.arc.at(0), before.end);
    if (after.curved) {
        after.arc = without_begin(after.arc, blend.cut_after);
        after.length = way_length(after.arc);
    } else {
        after.length -= blend.cut_after;
    }
    after.start = blend.piece.end;
}

}  // namespace gsim::motion::linuxcnc
