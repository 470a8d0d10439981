#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "motion/linuxcnc/blend_arc.h"

namespace gsim::motion::linuxcnc {

using Eigen::Vector3d;

namespace {

constexpr double kSharpest_rad = std::numbers::pi / 12;  // between two arcs

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// Returns the distance of the blend's centre from that of the leg's circle, which it touches from inside or
// outside.
double center_distance(const Leg& leg, double blend_mm) {
    return leg.bends_along ? leg.radius_mm - blend_mm : leg.radius_mm + blend_mm;
}

// Returns the angle at the centre of the leg's circle between the corner and the point at which the blend
// touches.
double cut_of(const Leg& leg, const Corner& corner, const Vector3d& blend_center) {
    return angle_between(corner.point - leg.center, blend_center - leg.center);
}

bool stays_near(const BlendCircle& circle, const Corner& corner, const BlendSpeeds& speeds) {
    return (circle.center - corner.point).norm() - speeds.radius_mm <= speeds.tolerance_mm;
}

BlendCircle between_lines(const Corner& corner, const BlendSpeeds& speeds) {
    const Vector3d inwards = (corner.out - corner.in).normalized();
    const double cut_mm = speeds.radius_mm / std::tan(speeds.half_angle_rad);
    return {corner.point + inwards * (speeds.radius_mm / std::sin(speeds.half_angle_rad)), cut_mm, cut_mm};
}

// Returns the distance from the corner to the point at which a circle touches a line that leads away along
// `outwards`. The circle must also touch that of the other leg. `inwards` is the line's normal towards the
// inside of the corner.
std::optional<double> cut_of_line(const Leg& arc, const Corner& corner, const Vector3d& outwards,
                                  const Vector3d& inwards, double radius_mm) {
    const Vector3d to_center = arc.center - corner.point;
    const double along = to_center.dot(outwards);
    const double across = radius_mm - to_center.dot(inwards);
    const double distance = center_distance(arc, radius_mm);
    const double square = distance * distance - across * across;
    if (!(square >= 0) || distance <= 0) return std::nullopt;
    const double root = std::sqrt(square);
    const double cut = std::abs(along - root) < std::abs(along + root) ? along - root : along + root;
    if (cut < 0) return std::nullopt;
    return cut;
}

std::optional<BlendCircle> line_then_arc(const Corner& corner, const Leg& before, const Leg& after,
                                         const BlendSpeeds& speeds) {
    const Vector3d inwards = corner.normal.cross(before.direction).normalized();
    const auto cut = cut_of_line(after, corner, -before.direction, inwards, speeds.radius_mm);
    if (!cut) return std::nullopt;
    BlendCircle circle{corner.point - before.direction * *cut + inwards * speeds.radius_mm, *cut, 0};
    circle.cut_after = cut_of(after, corner, circle.center);
    if (!stays_near(circle, corner, speeds) || circle.cut_after > after.room_rad) return std::nullopt;
    return circle;
}

std::optional<BlendCircle> arc_then_line(const Corner& corner, const Leg& before, const Leg& after,
                                         const BlendSpeeds& speeds) {
    const Vector3d inwards = corner.normal.cross(after.direction).normalized();
    const auto cut = cut_of_line(before, corner, after.direction, inwards, speeds.radius_mm);
    if (!cut) return std::nullopt;
    BlendCircle circle{corner.point + after.direction * *cut + inwards * speeds.radius_mm, 0, *cut};
    circle.cut_before = cut_of(before, corner, circle.center);
    if (!stays_near(circle, corner, speeds) || circle.cut_before > before.room_rad) return std::nullopt;
    return circle;
}

// The centre has its distance from both centres. Two points meet this; the one nearer to the corner is used.
std::optional<Vector3d> center_between(const Corner& corner, const Leg& before, const Leg& after,
                                       double radius_mm) {
    const Vector3d apart = after.center - before.center;
    const double distance = apart.norm();
    const double from_before = center_distance(before, radius_mm);
    const double from_after = center_distance(after, radius_mm);
    if (!(distance > 0) || from_before <= 0 || from_after <= 0) return std::nullopt;
    const double along =
        (from_before * from_before - from_after * from_after + distance * distance) / (2 * distance);
    const double square = from_before * from_before - along * along;
    if (!(square >= 0)) return std::nullopt;
    const Vector3d foot = before.center + apart * (along / distance);
    const Vector3d aside = corner.normal.cross(apart).normalized() * std::sqrt(square);
    const Vector3d one = foot + aside, other = foot - aside;
    return (one - corner.point).squaredNorm() < (other - corner.point).squaredNorm() ? one : other;
}

std::optional<BlendCircle> between_arcs(const Corner& corner, const Leg& before, const Leg& after,
                                        const BlendSpeeds& speeds) {
    if (speeds.half_angle_rad < kSharpest_rad) return std::nullopt;
    const auto center = center_between(corner, before, after, speeds.radius_mm);
    if (!center) return std::nullopt;
    const BlendCircle circle{*center, cut_of(before, corner, *center), cut_of(after, corner, *center)};
    if (!stays_near(circle, corner, speeds)) return std::nullopt;
    if (circle.cut_before > before.room_rad || circle.cut_after > after.room_rad) return std::nullopt;
    return circle;
}

}  // namespace

std::optional<BlendCircle> blend_circle(const Corner& corner, const Leg& before, const Leg& after,
                                        const BlendSpeeds& speeds) {
    if (before.curved && after.curved) return between_arcs(corner, before, after, speeds);
    if (before.curved) return arc_then_line(corner, before, after, speeds);
    if (after.curved) return line_then_arc(corner, before, after, speeds);
    return between_lines(corner, speeds);
}

}  // namespace gsim::motion::linuxcnc
