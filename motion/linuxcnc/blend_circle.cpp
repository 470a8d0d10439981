#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "motion/linuxcnc/blend_arc.h"

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

namespace {

constexpr double kMinCornerAngle_rad = std::numbers::pi / 12;  // between two arcs

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// Returns the distance of the blend's centre from that of the leg's circle, which it touches from inside or
// outside.
double center_distance(const Leg& leg, double blend_radius_mm) {
    return leg.turns_with_corner ? leg.radius_mm - blend_radius_mm : leg.radius_mm + blend_radius_mm;
}

// Returns the angle at the centre of the leg's circle between the corner and the point where the blend
// touches.
double arc_cut(const Leg& leg, const Corner& corner, const Vector3d& blend_center) {
    return angle_between(corner.point - leg.center, blend_center - leg.center);
}

bool is_within_tolerance(const BlendCircle& circle, const Corner& corner, const BlendSpeeds& speeds) {
    return (circle.center - corner.point).norm() - speeds.radius_mm <= speeds.tolerance_mm;
}

BlendCircle line_line_circle(const Corner& corner, const BlendSpeeds& speeds) {
    const Vector3d inward = (corner.out - corner.in).normalized();
    const double cut_mm = speeds.radius_mm / std::tan(speeds.half_angle_rad);
    return {corner.point + inward * (speeds.radius_mm / std::sin(speeds.half_angle_rad)), cut_mm, cut_mm};
}

// Returns the distance from the corner to the point where a circle touches a line that leads away along
// `outwards`. The circle must also touch that of the other leg. `inward` is the line's normal towards the
// inside of the corner.
std::optional<double> line_cut(const Leg& arc, const Corner& corner, const Vector3d& outwards,
                               const Vector3d& inward, double radius_mm) {
    const Vector3d to_center = arc.center - corner.point;
    const double along = to_center.dot(outwards);
    const double center_offset = radius_mm - to_center.dot(inward);
    const double distance = center_distance(arc, radius_mm);
    const double square = distance * distance - center_offset * center_offset;
    if (!(square >= 0) || distance <= 0) return std::nullopt;
    const double root = std::sqrt(square);
    const double cut = std::abs(along - root) < std::abs(along + root) ? along - root : along + root;
    if (cut < 0) return std::nullopt;
    return cut;
}

std::optional<BlendCircle> line_arc_circle(const Corner& corner, const Leg& before, const Leg& after,
                                           const BlendSpeeds& speeds) {
    const Vector3d inward = corner.normal.cross(before.direction).normalized();
    const auto cut = line_cut(after, corner, -before.direction, inward, speeds.radius_mm);
    if (!cut) return std::nullopt;
    BlendCircle circle{corner.point - before.direction * *cut + inward * speeds.radius_mm, *cut, 0};
    circle.cut_after = arc_cut(after, corner, circle.center);
    if (!is_within_tolerance(circle, corner, speeds) || circle.cut_after > after.available_rad)
        return std::nullopt;
    return circle;
}

std::optional<BlendCircle> arc_line_circle(const Corner& corner, const Leg& before, const Leg& after,
                                           const BlendSpeeds& speeds) {
    const Vector3d inward = corner.normal.cross(after.direction).normalized();
    const auto cut = line_cut(before, corner, after.direction, inward, speeds.radius_mm);
    if (!cut) return std::nullopt;
    BlendCircle circle{corner.point + after.direction * *cut + inward * speeds.radius_mm, 0, *cut};
    circle.cut_before = arc_cut(before, corner, circle.center);
    if (!is_within_tolerance(circle, corner, speeds) || circle.cut_before > before.available_rad)
        return std::nullopt;
    return circle;
}

// The centre has its distance from both centres. Two points meet this; the one nearer to the corner is used.
std::optional<Vector3d> blend_center_between(const Corner& corner, const Leg& before, const Leg& after,
                                             double radius_mm) {
    const Vector3d center_vector = after.center - before.center;
    const double distance = center_vector.norm();
    const double distance_before = center_distance(before, radius_mm);
    const double distance_after = center_distance(after, radius_mm);
    if (!(distance > 0) || distance_before <= 0 || distance_after <= 0) return std::nullopt;
    const double along =
        (distance_before * distance_before - distance_after * distance_after + distance * distance) /
        (2 * distance);
    const double square = distance_before * distance_before - along * along;
    if (!(square >= 0)) return std::nullopt;
    const Vector3d foot = before.center + center_vector * (along / distance);
    const Vector3d lateral = corner.normal.cross(center_vector).normalized() * std::sqrt(square);
    const Vector3d one = foot + lateral, other = foot - lateral;
    return (one - corner.point).squaredNorm() < (other - corner.point).squaredNorm() ? one : other;
}

std::optional<BlendCircle> arc_arc_circle(const Corner& corner, const Leg& before, const Leg& after,
                                          const BlendSpeeds& speeds) {
    if (speeds.half_angle_rad < kMinCornerAngle_rad) return std::nullopt;
    const auto center = blend_center_between(corner, before, after, speeds.radius_mm);
    if (!center) return std::nullopt;
    const BlendCircle circle{*center, arc_cut(before, corner, *center), arc_cut(after, corner, *center)};
    if (!is_within_tolerance(circle, corner, speeds)) return std::nullopt;
    if (circle.cut_before > before.available_rad || circle.cut_after > after.available_rad)
        return std::nullopt;
    return circle;
}

}  // namespace

std::optional<BlendCircle> blend_circle(const Corner& corner, const Leg& before, const Leg& after,
                                        const BlendSpeeds& speeds) {
    if (before.curved && after.curved) return arc_arc_circle(corner, before, after, speeds);
    if (before.curved) return arc_line_circle(corner, before, after, speeds);
    if (after.curved) return line_arc_circle(corner, before, after, speeds);
    return line_line_circle(corner, speeds);
}

}  // namespace gsim::motion::linuxcnc
