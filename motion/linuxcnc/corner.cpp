#include "motion/linuxcnc/corner.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

Corner corner_between(const SubSegment& before, const SubSegment& after, const Axes& axes) {
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
void fit_circle(Leg& leg, const Corner& corner, const Vector3d& center, bool turns_with_corner,
                double share_rad) {
    leg.curved = true;
    leg.center = center;
    leg.radius_mm = (corner.point - center).norm();
    leg.turns_with_corner = turns_with_corner;
    leg.available_rad = std::min(share_rad, turns_with_corner ? corner.half_angle_rad : std::numbers::pi / 2);
    leg.available_mm =
        leg.radius_mm * (turns_with_corner ? std::sin(leg.available_rad / 4) : leg.available_rad);
    if (turns_with_corner) leg.half_angle_rad = corner.half_angle_rad - leg.available_rad / 4;
}

}  // namespace

Leg leg_before(const SubSegment& sub_segment, const Corner& corner) {
    Leg leg;
    leg.direction = corner.in;
    leg.half_angle_rad = corner.half_angle_rad;
    leg.available_mm = std::min(sub_segment.length, sub_segment.nominal_length / 2);
    if (!sub_segment.curved) return leg;
    const Arc& arc = sub_segment.arc;
    const Vector3d center = arc.center + arc.lift + corner.in * radius_slope(arc);
    const bool turns_with_corner = (corner.point - center).dot(corner.out) < 0;
    fit_circle(leg, corner, center, turns_with_corner, arc.sweep_rad * 2 / 3);
    if (turns_with_corner)
        leg.direction = (corner.point - arc.at(arc.sweep_rad - leg.available_rad / 2)).normalized();
    return leg;
}

Leg leg_after(const SubSegment& sub_segment, const Corner& corner) {
    Leg leg;
    leg.direction = corner.out;
    leg.half_angle_rad = corner.half_angle_rad;
    leg.available_mm = sub_segment.length / 2;
    if (!sub_segment.curved) return leg;
    const Arc& arc = sub_segment.arc;
    const Vector3d center = arc.center + corner.out * radius_slope(arc);
    const bool turns_with_corner = (corner.point - center).dot(corner.in) >= 0;
    fit_circle(leg, corner, center, turns_with_corner, arc.sweep_rad / 3);
    if (turns_with_corner) leg.direction = (arc.at(leg.available_rad / 2) - corner.point).normalized();
    return leg;
}

}  // namespace gsim::motion::linuxcnc
