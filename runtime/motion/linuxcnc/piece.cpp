#include "runtime/motion/linuxcnc/piece.h"

#include <algorithm>
#include <cmath>

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

double whole_acceleration(const Piece& piece) {
    const bool halved = piece.after_parabola || piece.term == Term::parabola;
    const double kept = 1 - std::max(piece.kink_at_start, piece.kink_at_end);
    return piece.full_acceleration * kept * (halved ? 0.5 : 1.0);
}

double acceleration(const Piece& piece) {
    return whole_acceleration(piece) * (piece.curved ? piece.tangential_share : 1.0);
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

// A spiral is measured by the mean of its pace at both ends.
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

void share_acceleration(Piece& piece) {
    const double whole = whole_acceleration(piece);
    const double radius_mm = effective_radius_mm(piece.arc);
    const double across = piece.max_speed * piece.max_speed / radius_mm;
    if (across > kNormalShare * whole) {
        piece.max_speed = std::sqrt(kNormalShare * whole * radius_mm);
        if (piece.max_speed < piece.requested_speed) piece.speed_limit = {LimitKind::centripetal, -1};
        return;
    }
    const double share = across / whole;
    piece.tangential_share = std::sqrt(1 - share * share);
}

}  // namespace

void settle(Piece& piece, double period_s) {
    piece.max_speed = std::min(piece.max_speed, piece.length / period_s);
    if (piece.curved) share_acceleration(piece);
    if (piece.after_tangent) {
        piece.max_speed = std::min(piece.max_speed, piece.length / (kLeastPeriods * period_s));
    }
    piece.settled = true;
}

}  // namespace gsim::motion::linuxcnc
