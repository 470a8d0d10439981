#include "motion/linuxcnc/piece.h"

#include <algorithm>
#include <cmath>

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

namespace {

double beside_kinks(const Piece& piece) {
    return piece.full_acceleration * (1 - std::max(piece.kink_at_start, piece.kink_at_end));
}

}  // namespace

double whole_acceleration(const Piece& piece) {
    const bool halved = piece.after_parabola || piece.term == Term::parabola;
    return beside_kinks(piece) * (halved ? 0.5 : 1.0);
}

double acceleration(const Piece& piece) {
    return whole_acceleration(piece) * (piece.curved ? piece.tangential_share : 1.0);
}

double acceleration_alone(const Piece& piece, const Planning& planning) {
    if (!planning.since_2_10) return acceleration(piece);
    return beside_kinks(piece) * (piece.curved ? piece.tangential_share : 1.0);
}

double target_speed(const Piece& piece, double share) {
    const double speed = std::min(piece.requested_speed * share, piece.max_speed);
    return piece.path_limited ? std::min(speed, piece.max_path_speed) : speed;
}

Vector3d start_direction(const Piece& piece) {
    return piece.curved ? piece.arc.tangent(0) : piece.direction;
}

Vector3d end_direction(const Piece& piece) {
    return piece.curved ? piece.arc.tangent(piece.arc.sweep_rad) : piece.direction;
}

// The length of a spiral is the mean of its path length per angle at both ends.
double way_length(const Arc& arc) {
    const double radial = (arc.end_radius_mm - arc.radius_mm) / arc.sweep_rad;
    const double pace = (std::hypot(arc.radius_mm, radial) + std::hypot(arc.end_radius_mm, radial)) / 2;
    return std::hypot(arc.sweep_rad * pace, arc.lift.norm());
}

double effective_radius_mm(const Arc& arc) {
    const double radial = (arc.end_radius_mm - arc.radius_mm) / arc.sweep_rad;
    const double pace_square = radial * radial + arc.radius_mm * arc.radius_mm;
    const double radius = pace_square * std::sqrt(pace_square) / (pace_square + radial * radial);
    return arc.lift.squaredNorm() / radius + radius;
}

namespace {

// The limit assumes that the normal acceleration comes within a period at the start of the arc, and again at
// its end.
double speed_by_jerk(const Piece& piece, double radius_mm, const Planning& planning) {
    const double turning =
        std::cbrt(radius_mm * radius_mm * piece.path_jerk * piece.arc.sweep_rad / (2 + piece.arc.sweep_rad));
    const double speeding = piece.path_jerk * radius_mm / (3 * kTangentialShare * whole_acceleration(piece));
    return std::min({std::sqrt(piece.path_jerk * radius_mm * planning.period_s), turning, speeding});
}

void limit_by_acceleration(Piece& piece, double radius_mm) {
    const double whole = whole_acceleration(piece);
    const double across = piece.max_speed * piece.max_speed / radius_mm;
    if (across > kNormalShare * whole) {
        piece.max_speed = std::sqrt(kNormalShare * whole * radius_mm);
        piece.tangential_share = kTangentialShare;
        if (piece.max_speed < piece.requested_speed) piece.speed_limit = {LimitKind::centripetal, -1};
        return;
    }
    const double share = across / whole;
    piece.tangential_share = std::sqrt(1 - share * share);
}

}  // namespace

void limit_on_arc(Piece& piece, const Planning& planning) {
    const double radius_mm = effective_radius_mm(piece.arc);
    limit_by_acceleration(piece, radius_mm);
    if (!std::isfinite(piece.path_jerk)) return;
    const double speed = speed_by_jerk(piece, radius_mm, planning);
    if (speed >= piece.max_speed) return;
    piece.max_speed = speed;
    if (speed < piece.requested_speed) piece.speed_limit = {LimitKind::jerk, -1};
    const double share = speed * speed / radius_mm / whole_acceleration(piece);
    if (share < 1) piece.tangential_share = std::sqrt(1 - share * share);
}

void settle(Piece& piece, const Planning& planning) {
    piece.max_speed = std::min(piece.max_speed, piece.length / planning.period_s);
    if (piece.curved) limit_on_arc(piece, planning);
    if (piece.after_tangent) {
        piece.max_speed = std::min(piece.max_speed, piece.length / (kLeastPeriods * planning.period_s));
    }
    piece.settled = true;
}

}  // namespace gsim::motion::linuxcnc
