#include "motion/linuxcnc/piece_of_move.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "motion/exact_stop/line_move.h"
#include "motion/path/joint_changes.h"
#include "motion/path/lead_path.h"

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

namespace {

constexpr double kLeastChange = 1e-7;  // LinuxCNC makes no move of less
constexpr double kAcross = 1e-9;       // share of an axis in a plane below which the plane lies across it

JointRole piece_role(const JointChanges& changes, bool curved) {
    if (curved || changes.norm(JointRole::position) > 0) return JointRole::position;
    return changes.norm(JointRole::secondary) > 0 ? JointRole::secondary : JointRole::rotary;
}

// Largest change of a joint divided by its limit, and the joint that has it.
struct Need {
    double value = 0;
    int joint = -1;

    void raise(double other, int by) {
        if (other > value) *this = {other, by};
    }
    // Returns the limit along a path of `length`; unlimited if no joint needs one.
    double along(double length) const { return value > 0 ? length / value : kUnlimited; }
};

struct Needs {
    Need speed;
    Need acceleration;
    Need jerk;
    bool jerk_free = false;  // a joint has no jerk limit
};

// LinuxCNC uses only the jerks of X, Y and Z round an arc.
Needs needs_of(const PlannerSetup& setup, const JointChanges& changes, bool curved) {
    Needs needs;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        const double change = std::abs(changes.of(joint));
        if (change == 0) continue;
        const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
        needs.speed.raise(change / limits.max_speed, joint);
        needs.acceleration.raise(change / limits.max_acceleration, joint);
        if (curved && setup.role(joint) != JointRole::position) continue;
        needs.jerk.raise(change / limits.max_jerk, joint);
        needs.jerk_free |= std::isinf(limits.max_jerk);
    }
    return needs;
}

// Returns the limit of the slowest axis in the arc's plane.
double least_in_plane(const Vector3d& limits, const Arc& arc) {
    double least = kUnlimited;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::hypot(arc.u[axis], arc.v[axis]) > kAcross) least = std::min(least, limits[axis]);
    }
    return least;
}

void limit_line(Piece& piece, const Needs& needs) {
    piece.max_speed = needs.speed.along(piece.length);
    piece.full_acceleration = needs.acceleration.along(piece.length);
}

// Returns the path length round an arc, by the smaller of its radii.
double way_round_mm(const Arc& arc) {
    const double radius_mm = std::min(arc.radius_mm, arc.end_radius_mm);
    return std::hypot(radius_mm * arc.sweep_rad, arc.end_radius_mm - arc.radius_mm);
}

// The chord counts for the joints, the path round the arc for the axes of its plane.
void limit_arc(Piece& piece, const Axes& axes, Needs& needs) {
    const Arc& arc = piece.arc;
    const double acceleration = least_in_plane(axes.max_acceleration_mm_s2(), arc);
    const double change = arc.end_radius_mm - arc.radius_mm;
    const double radius_mm = std::min(arc.radius_mm, arc.end_radius_mm);
    const double round_mm = way_round_mm(arc);
    const double bend_mm = std::hypot(change / arc.sweep_rad, radius_mm);
    const double across = std::sqrt(kNormalShare * acceleration * bend_mm);
    const double speed = std::min(across, least_in_plane(axes.max_speed_mm_s(), arc));
    if (across <= speed) piece.speed_limit = {LimitKind::centripetal, -1};
    needs.speed.raise(round_mm / speed, -1);
    needs.acceleration.raise(round_mm / acceleration, -1);
    needs.jerk.raise(round_mm / least_in_plane(axes.max_jerk_mm_s3(), arc), -1);
    const double whole_mm = std::hypot(round_mm, arc.lift.norm());
    piece.max_speed = needs.speed.along(whole_mm);
    piece.full_acceleration = needs.acceleration.along(whole_mm);
}

double asked_speed(const PathMove& move, const Piece& piece, JointRole role) {
    if (move.rapid) return kUnlimited;
    if (move.rules.least_duration_s > 0) return piece.length / move.rules.least_duration_s;
    return role == JointRole::rotary ? move.rules.orientation_speed_rad_s : move.rules.programmed_speed_mm_s;
}

LimitedBy joint_limit(LimitKind kind, int joint) {
    return {kind, static_cast<std::int8_t>(joint)};
}

void set_speeds(Piece& piece, const PathMove& move, JointRole role, const Needs& needs, double period_s) {
    const double asked = asked_speed(move, piece, role);
    if (piece.speed_limit.kind != LimitKind::centripetal || needs.speed.joint >= 0) {
        piece.speed_limit = joint_limit(LimitKind::joint_speed, needs.speed.joint);
    }
    if (asked <= piece.max_speed) {
        piece.speed_limit = {move.rules.least_duration_s > 0 ? LimitKind::time : LimitKind::feed, -1};
    }
    piece.requested_speed = std::min(asked, piece.max_speed);
    piece.path_limited = role != JointRole::rotary;
    piece.max_path_speed = move.rules.max_path_speed_mm_s;
    if (piece.path_limited && piece.max_path_speed < piece.requested_speed) {
        piece.speed_limit = {LimitKind::path_speed, -1};
    }
    piece.max_speed = std::min(piece.max_speed, piece.length / period_s);
}

void set_acceleration(Piece& piece, const PathMove& move, JointRole role, const Needs& needs,
                      double period_s) {
    piece.acceleration_limit = joint_limit(LimitKind::acceleration, needs.acceleration.joint);
    const double limit = role == JointRole::rotary ? move.rules.orientation_acceleration_rad_s2
                                                   : move.rules.path_acceleration_mm_s2;
    if (limit < piece.full_acceleration) {
        piece.full_acceleration = limit;
        piece.acceleration_limit = {LimitKind::path_acceleration, -1};
    }
    // The speed is reached within a period if no limit applies.
    if (!std::isfinite(piece.full_acceleration)) piece.full_acceleration = piece.max_speed / period_s;
}

// One joint without a limit leaves the complete move without S-curves, as in LinuxCNC.
void set_jerk(Piece& piece, JointRole role, const Needs& needs, const Planning& planning) {
    if (!planning.s_curves) return;
    piece.path_jerk = planning.path_jerk * (role == JointRole::rotary ? kRadPerDeg : 1);
    const double length =
        piece.curved ? std::hypot(way_round_mm(piece.arc), piece.arc.lift.norm()) : piece.length;
    if (!needs.jerk_free) piece.jerk = needs.jerk.along(length);
    if (std::isfinite(piece.jerk)) piece.jerk = std::min(piece.jerk, piece.path_jerk);
}

Term term_of(rrs::PathMode mode) {
    switch (mode) {
        case rrs::PathMode::exact_path: return Term::exact;
        case rrs::PathMode::continuous: return Term::parabola;
        case rrs::PathMode::exact_stop: break;
    }
    return Term::stop;
}

bool has_speed(const PathMove& move, JointRole role) {
    if (move.rapid || move.rules.least_duration_s > 0) return true;
    return role == JointRole::rotary ? move.rules.orientation_speed_rad_s > 0
                                     : move.rules.programmed_speed_mm_s > 0;
}

// Rejects values from which no sub-segment can be made.
Planned check_values(const PathMove& move, const Piece& piece, JointRole role) {
    if (!move.start.allFinite() || !move.end.allFinite() || !(piece.length < kUnlimited)) {
        return refused(rrs::Status::RRS_INVALID_PARAMETER, "The move is too long, or leads to no position.");
    }
    if (piece.length == 0) return {};
    if (!has_speed(move, role) || !(move.rules.max_path_speed_mm_s > 0)) return no_programmed_speed();
    return {};
}

Planned check_time(const Piece& piece) {
    const double speed = target_speed(piece);
    if (piece.length == 0 || piece.length / speed + speed / piece.full_acceleration <= kLongest_s) return {};
    return refused(
        rrs::Status::RRS_INVALID_PARAMETER,
        fmt::format("The move is too long or too slow: it would take more than {} s.", kLongest_s));
}

void set_way(Piece& piece, const Axes& axes, const PathMove& move, const JointChanges& changes,
             JointRole role) {
    piece.target_id = move.target_id;
    piece.curved = move.kind == SegmentKind::circular;
    piece.rapid = move.rapid;
    piece.obeyed = move.obeyed;
    piece.follows_spindle = move.rules.follows_spindle && !move.rapid;
    piece.turns = changes.norm(JointRole::secondary) > 0 || changes.norm(JointRole::rotary) > 0;
    piece.start = move.start;
    piece.end = move.end;
    piece.length = piece.curved ? way_length(move.arc) : changes.norm(role);
    piece.nominal_length = piece.length;
    if (piece.curved) {
        piece.arc = move.arc;
    } else if (role == JointRole::position) {
        piece.direction = (axes.point(move.end) - axes.point(move.start)) / piece.length;
    }
}

void set_limits(Piece& piece, const PlannerSetup& setup, const Axes& axes, const PathMove& move,
                const JointChanges& changes, JointRole role, const Planning& planning) {
    Needs needs = needs_of(setup, changes, piece.curved);
    if (piece.curved) {
        limit_arc(piece, axes, needs);
    } else {
        limit_line(piece, needs);
    }
    set_speeds(piece, move, role, needs, planning.period_s);
    set_acceleration(piece, move, role, needs, planning.period_s);
    piece.term = term_of(move.mode);
    piece.tolerance_mm = move.mode == rrs::PathMode::continuous ? move.tolerance_mm : 0;
    set_jerk(piece, role, needs, planning);
    if (piece.curved && planning.since_2_10) limit_on_arc(piece, planning);
}

}  // namespace

bool surely_makes_piece(const PlannerSetup& setup, const PathMove& move) {
    if (move.kind == SegmentKind::circular || move.rapid || move.rules.least_duration_s > 0) return false;
    if (!move.start.allFinite() || !move.end.allFinite()) return false;
    const JointChanges changes(setup, move.start, move.end, kLeastChange);
    if (changes.norm(JointRole::secondary) > 0 || changes.norm(JointRole::rotary) > 0) return false;
    const double length_mm = changes.norm(JointRole::position);
    const double asked_mm_s = move.rules.programmed_speed_mm_s;
    double speed_mm_s = std::min(asked_mm_s, move.rules.max_path_speed_mm_s);
    double acceleration_mm_s2 = move.rules.path_acceleration_mm_s2;
    for (const int joint : setup.position_joints) {
        if (joint < 0) continue;
        const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
        speed_mm_s = std::min(speed_mm_s, limits.max_speed);
        acceleration_mm_s2 = std::min(acceleration_mm_s2, limits.max_acceleration);
    }
    return length_mm > 0 && speed_mm_s > 0 &&
           length_mm / speed_mm_s + asked_mm_s / acceleration_mm_s2 <= kLongest_s;
}

tl::expected<Piece, PlanError> piece_of(const PlannerSetup& setup, const Axes& axes, const PathMove& move,
                                        const Planning& planning) {
    const JointChanges changes(setup, move.start, move.end, kLeastChange);
    const JointRole role = piece_role(changes, move.kind == SegmentKind::circular);
    Piece piece;
    set_way(piece, axes, move, changes, role);
    if (Planned values = check_values(move, piece, role); !values) return tl::unexpected(values.error());
    if (piece.length > 0) set_limits(piece, setup, axes, move, changes, role, planning);
    if (Planned time = check_time(piece); !time) return tl::unexpected(time.error());
    return piece;
}

}  // namespace gsim::motion::linuxcnc
