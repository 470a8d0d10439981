#include "toolpath/model/arc_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/units.h"

namespace gsim::path {

namespace {

using Eigen::Vector3d;

constexpr double kMinArc_mm = 1e-6;
constexpr double kMaxArcTurn_deg = 360e3;

// Returns the angle from one radius to another about `normal`, in [0, 2 pi).
double angle_between(const Vector3d& from, const Vector3d& to, const Vector3d& normal) {
    const double angle = std::atan2(normal.dot(from.cross(to)), from.dot(to));
    return angle < 0 ? angle + kTurn_rad : angle;
}

Result<ArcShape> arc_through(const Vector3d& start, const Vector3d& via, const Vector3d& end) {
    const Vector3d chord = end - start;
    const Vector3d to_via = via - start;
    if (chord.norm() < kMinArc_mm) {
        return Unexpected(
            "an arc through 'via_mm' must not end at its start; give a full circle by 'center_mm'");
    }
    const Vector3d cross = chord.cross(to_via);
    if (cross.norm() < kMinArc_mm * chord.norm()) {
        return Unexpected("the via point is on the line through start and end; use a linear motion");
    }
    // Centre of the circle through three points, from the first one.
    const Vector3d to_center =
        (to_via.squaredNorm() * cross.cross(chord) + chord.squaredNorm() * to_via.cross(cross)) /
        (2 * cross.squaredNorm());
    ArcShape arc;
    arc.center = start + to_center;
    arc.first = -to_center;
    arc.normal = -cross.normalized();
    arc.end_radius_mm = arc.radius_mm();
    arc.turn_rad = angle_between(arc.first, end - arc.center, arc.normal);
    return arc;
}

Result<ArcShape> arc_about_center(const Vector3d& start, const CenterArc& given, const Vector3d& end) {
    ArcShape arc;
    const Vector3d normal = to_eigen(given.normal);
    if (!(normal.norm() > 0)) return Unexpected("the 'normal' of an arc must not be 0 0 0");
    if (!(given.turn_deg > 0 && given.turn_deg <= kMaxArcTurn_deg)) {
        return Unexpected(fmt::format(
            "'turn_deg' must be above 0 and at most 360000; it is {}. The direction is that of 'normal'",
            given.turn_deg));
    }
    arc.normal = normal.normalized();
    const Vector3d center = to_eigen(given.center_mm);
    arc.center = center + arc.normal * arc.normal.dot(start - center);
    arc.first = start - arc.center;
    arc.rise_mm = arc.normal.dot(end - arc.center);
    const Vector3d last = end - arc.center - arc.normal * arc.rise_mm;
    arc.end_radius_mm = last.norm();
    arc.turn_rad = given.turn_deg * kRadPerDeg;
    if (arc.radius_mm() < kMinArc_mm) return Unexpected("the arc starts at its centre");
    if (std::abs(arc.end_radius_mm - arc.radius_mm()) > kArcTolerance_mm) {
        return Unexpected(fmt::format("the arc starts {:.6g} mm from its centre and ends {:.6g} mm from it",
                                      arc.radius_mm(), arc.end_radius_mm));
    }
    const double off = std::remainder(arc.turn_rad - angle_between(arc.first, last, arc.normal), kTurn_rad);
    if (std::abs(off) * arc.radius_mm() > kArcTolerance_mm) {
        const double right = (arc.turn_rad - off) * kDegPerRad;
        return Unexpected(fmt::format("'turn_deg' {} does not reach the end; {:.6g} would", given.turn_deg,
                                      right > 0 ? right : right + 360));
    }
    arc.turn_rad = std::max(arc.turn_rad - off, std::abs(off));
    return arc;
}

}  // namespace

Vector3d ArcShape::at(double share) const {
    const double angle = share * turn_rad;
    const double scale = 1 + share * (end_radius_mm / radius_mm() - 1);
    return center + scale * (std::cos(angle) * first + std::sin(angle) * normal.cross(first)) +
           share * rise_mm * normal;
}

Result<ArcShape> arc_shape(const Vector& start_mm, const Point& end) {
    const Vector3d start = to_eigen(start_mm);
    const Vector3d last = to_eigen(end.position_mm);
    if (const auto* via = std::get_if<ViaPoint>(&end.arc))
        return arc_through(start, to_eigen(via->via_mm), last);
    return arc_about_center(start, std::get<CenterArc>(end.arc), last);
}

double ArcShape::radius_mm() const {
    return first.norm();
}

}  // namespace gsim::path
