#include "motion/linuxcnc/corner.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

Corner corner_between(const Piece& before, const Piece& after, const Axes& axes) {
    Corner corner;
    corner.point = axes.point(after.start);
    corner.in = end_direction(before);
    corner.out = start_direction(after);
    corner.normal = corner.in.cross(corner.out).stableNormalized();
    corner.half_angle_rad = std::acos(std::clamp(-corner.in.dot(corner.out), -1.0, 1.0)) / 2;
    return corner;
}

namespace {

double radius_slope(const Arc& arc) {
    return (arc.end_radius_mm - arc.radius_mm) / arc.sweep_rad;
}

// Fits a circle to the arc at its end in the corner. The blend may use `share_rad` of it, and no more than
// the corner's shape allows.
void fit_circle(Leg& leg, const Corner& corner, const Vector3d& center, bool bends_along, double share_rad) {
    leg.curved = true;
    leg.center = center;
    leg.radius_mm = (corner.point - center).norm();
    leg.bends_along = bends_along;
    leg.room_rad = std::min(share_rad, bends_along ? corner.half_angle_rad : std::numbers::pi / 2);
    leg.room_mm = leg.radius_mm * (bends_along ? std::sin(leg.room_rad / 4) : leg.room_rad);
    if (bends_along) leg.half_angle_rad = corner.half_angle_rad - leg.room_rad / 4;
}

}  // namespace

Leg leg_before(const Piece& piece, const Corner& corner) {
    Leg leg;
    leg.direction = corner.in;
    leg.half_angle_rad = corner.half_angle_rad;
    leg.room_mm = std::min(piece.length, piece.nominal_length / 2);
    if (!piece.curved) return leg;
    const Arc& arc = piece.arc;
    const Vector3d center = arc.center + arc.lift + corner.in * radius_slope(arc);
    const bool bends_along = (corner.point - center).dot(corner.out) < 0;
    fit_circle(leg, corner, center, bends_along, arc.sweep_rad * 2 / 3);
    if (bends_along) leg.direction = (corner.point - arc.at(arc.sweep_rad - leg.room_rad / 2)).normalized();
    return leg;
}

Leg leg_after(const Piece& piece, const Corner& corner) {
    Leg leg;
    leg.direction = corner.out;
    leg.half_angle_rad = corner.half_angle_rad;
    leg.room_mm = piece.length / 2;
    if (!piece.curved) return leg;
    const Arc& arc = piece.arc;
    const Vector3d center = arc.center + corner.out * radius_slope(arc);
    const bool bends_along = (corner.point - center).dot(corner.in) >= 0;
    fit_circle(leg, corner, center, bends_along, arc.sweep_rad / 3);
    if (bends_along) leg.direction = (arc.at(leg.room_rad / 2) - corner.point).normalized();
    return leg;
}

}  // namespace gsim::motion::linuxcnc
