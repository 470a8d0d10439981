#include "motion/path/circle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace gsim::motion {

namespace {

using Eigen::Vector3d;
using rrs::Status;

constexpr double kSmallestRadius_mm = 1e-6;
constexpr double kLargestRadius_mm = 1e9;  // beyond, the centre is too far away for points exact to 1e-6 mm
constexpr double kCircleRounding_mm = 1e-9;
constexpr double kMaxSweep_rad = 1e6;
constexpr double kNormTolerance = 1e-6;
constexpr double kCoincident_mm = 1e-6;

// A vector from a point of the axis, split into its parts along and across the axis.
struct AxialSplit {
    AxialSplit(const Vector3d& vector, const Vector3d& axis)
        : along(axis.dot(vector)), across(vector - along * axis), radius(across.norm()) {}
    double along;
    Vector3d across;
    double radius;
};

// Removes full turns. Most angles have none, and std::remainder() takes its time.
double wrap_to_pi(double angle_rad) {
    return std::abs(angle_rad) < std::numbers::pi ? angle_rad
                                                  : std::remainder(angle_rad, 2 * std::numbers::pi);
}

tl::unexpected<PlanError> impossible_circle(std::string reason) {
    return make_plan_error(Status::RRS_CIRCLE_IMPOSSIBLE, std::move(reason));
}

PlanResult check_radii(double start_mm, double end_mm, double allowed_mm) {
    if (!(start_mm >= kSmallestRadius_mm))
        return impossible_circle("The centre of the arc coincides with its start.");
    if (!(start_mm <= kLargestRadius_mm)) {
        return impossible_circle(fmt::format("The arc's radius of {} mm is too large; the maximum is {} mm.",
                                             start_mm, kLargestRadius_mm));
    }
    if (std::abs(end_mm - start_mm) <= allowed_mm) return {};
    return impossible_circle(fmt::format(
        "The arc's radius is {} mm at its start but {} mm at its end; they may differ by at most {} mm.",
        start_mm, end_mm, allowed_mm));
}

// The axis is of unit length here.
PlanResult build(const Vector3d& start, const Vector3d& end, const Vector3d& center, const Vector3d& axis,
                 double sweep_rad, double tolerance_mm, Arc& arc) {
    const AxialSplit from(start - center, axis);
    const AxialSplit to(end - center, axis);
    const double allowed_mm =
        std::min(tolerance_mm, from.radius / 2) + kCircleRounding_mm + 1e-12 * from.radius;
    if (PlanResult radii = check_radii(from.radius, to.radius, allowed_mm); !radii) return radii;
    arc.u = from.across / from.radius;
    arc.v = axis.cross(arc.u);
    const double end_angle = std::atan2(to.across.dot(arc.v), to.across.dot(arc.u));
    const double sweep_error_rad = wrap_to_pi(end_angle - sweep_rad);
    arc.sweep_rad = sweep_rad + sweep_error_rad;
    if (std::abs(sweep_error_rad) * from.radius > allowed_mm || !(arc.sweep_rad > 0)) {
        return impossible_circle(
            fmt::format("The target of the arc is {} mm along the circle from the end of its sweep of {} "
                        "rad; {} mm are allowed.",
                        sweep_error_rad * from.radius, sweep_rad, allowed_mm));
    }
    const double rise = to.along - from.along;
    arc.center = center + from.along * axis;
    arc.lift = std::abs(rise) > kCircleRounding_mm ? Vector3d(rise * axis) : Vector3d::Zero();
    arc.radius_mm = from.radius;
    arc.end_radius_mm = std::abs(to.radius - from.radius) > kCircleRounding_mm ? to.radius : from.radius;
    return {};
}

}  // namespace

PlanResult arc_about(const Vector3d& start, const Vector3d& end, const Vector3d& center, const Vector3d& axis,
                     double sweep_rad, double tolerance_mm, Arc& arc) {
    if (!center.allFinite())
        return make_plan_error(Status::RRS_INVALID_PARAMETER, "The centre of the arc is not finite.");
    const double norm = axis.norm();
    if (!(std::abs(norm - 1) <= kNormTolerance)) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("The axis of the arc must be a unit vector; its length is {}.", norm));
    }
    if (!(sweep_rad > 0 && sweep_rad <= kMaxSweep_rad)) {
        return make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("The sweep of an arc must be greater than 0 and at most {} rad; it is {}.",
                        kMaxSweep_rad, sweep_rad));
    }
    return build(start, end, center, axis / norm, sweep_rad, tolerance_mm, arc);
}

// The three points are counter-clockwise about the normal (via - start) x (end - start), so travel is, too.
PlanResult arc_through(const Vector3d& start, const Vector3d& via, const Vector3d& end, Arc& arc) {
    const Vector3d to_via = via - start;
    const Vector3d to_end = end - start;
    const double chord = to_end.norm();
    if (!(std::min({chord, to_via.norm(), (end - via).norm()}) > kCoincident_mm)) {
        return impossible_circle("Start, via point and target of the arc must be three different points.");
    }
    const Vector3d normal = to_via.cross(to_end);
    const double area = normal.norm();
    const Vector3d to_center =
        (normal.cross(to_via) * (chord * chord) + to_end.cross(normal) * to_via.squaredNorm()) /
        (2 * area * area);
    if (!(area / chord > kCircleRounding_mm && to_center.norm() <= kLargestRadius_mm)) {
        return impossible_circle(
            "The via point of the arc is on the straight line from its start to its target.");
    }
    const Vector3d axis = normal / area;
    const Vector3d u = -to_center.normalized();
    const Vector3d from_center = to_end - to_center;
    const double angle = std::atan2(from_center.dot(axis.cross(u)), from_center.dot(u));
    const double sweep_rad = angle > 0 ? angle : angle + 2 * std::numbers::pi;
    return build(start, end, start + to_center, axis, sweep_rad, 0, arc);
}

}  // namespace gsim::motion
