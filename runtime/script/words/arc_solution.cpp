#include "runtime/script/words/arc_solution.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"

namespace gsim::script {

using Eigen::Vector2d;

namespace {

constexpr double kPointTolerance_mm = 1e-6;

double distance(const Vector2d& from, const Vector2d& to) {
    const double x = to.x() - from.x();
    const double y = to.y() - from.y();
    return std::sqrt(x * x + y * y);
}

/// Returns the centre: from the middle of the chord at a signed distance to the left of start -> end.
Vector2d center_left_of_chord(const ArcEnds& ends, double left_mm) {
    const double x = ends.end.x() - ends.start.x();
    const double y = ends.end.y() - ends.start.y();
    const double chord = distance(ends.start, ends.end);
    return {(ends.start.x() + ends.end.x()) / 2 - y / chord * left_mm,
            (ends.start.y() + ends.end.y()) / 2 + x / chord * left_mm};
}

}  // namespace

double ArcRules::radii_tolerance(double radius_mm, bool inches) const {
    const double min = inches ? radii_tolerance_inch_mm : radii_tolerance_mm;
    return std::max(min, std::min(radii_tolerance_share * radius_mm, radii_tolerance_growth * min));
}

double swept_rad(const ArcEnds& ends, const Vector2d& center) {
    const double x = ends.start.x() - center.x();
    const double y = ends.start.y() - center.y();
    const double to_x = ends.end.x() - center.x();
    const double to_y = ends.end.y() - center.y();
    const double left = x * to_y - y * to_x;
    const double angle = std::atan2(ends.ccw ? left : -left, x * to_x + y * to_y);
    const double positive = angle < 0 ? angle + kTurn_rad : angle;
    return positive > 0 ? positive : kTurn_rad;
}

Result<ArcSolution> arc_by_center(const ArcEnds& ends, const Vector2d& center, const ArcRules& rules,
                                  bool inches) {
    const double at_start = distance(center, ends.start);
    const double at_end = distance(center, ends.end);
    if (std::abs(at_start - at_end) > rules.radii_tolerance(std::max(at_start, at_end), inches)) {
        return Unexpected(fmt::format(
            "the arc is impossible: its radius is {:.6f} mm at the start and {:.6f} mm at the end", at_start,
            at_end));
    }
    if (at_start < kPointTolerance_mm) return Unexpected("the arc has no radius: its centre is the start");
    const bool closed = distance(ends.start, ends.end) < kPointTolerance_mm;
    return ArcSolution{center, closed ? kTurn_rad : swept_rad(ends, center)};
}

Result<ArcSolution> arc_by_radius(const ArcEnds& ends, double radius_mm, const ArcRules& rules) {
    const double half = distance(ends.start, ends.end) / 2;
    if (half < kPointTolerance_mm / 2)
        return Unexpected("a full circle cannot be given by R; give its centre");
    const double radius = std::abs(radius_mm);
    if (half - radius > rules.max_radius_shortfall_mm) {
        return Unexpected(fmt::format(
            "the arc is impossible: R is {:.6f} mm, but half the distance to the end is {:.6f} mm", radius,
            half));
    }
    const double height = std::sqrt(std::max(radius * radius - half * half, 0.0));
    const double angle = 2 * std::asin(std::min(half / radius, 1.0));
    const bool left = ends.ccw == (radius_mm > 0);
    return ArcSolution{center_left_of_chord(ends, left ? height : -height),
                       radius_mm > 0 ? angle : kTurn_rad - angle};
}

Result<ArcSolution> arc_by_angle(const ArcEnds& ends, double angle_rad) {
    const double half = distance(ends.start, ends.end) / 2;
    if (half < kPointTolerance_mm / 2) {
        return Unexpected("an arc given by its angle needs an end other than its start, or its centre");
    }
    if (angle_rad >= kTurn_rad) return Unexpected("AR= of an arc with an end must be below 360 degrees");
    const double left = half / std::tan(angle_rad / 2);
    return ArcSolution{center_left_of_chord(ends, ends.ccw ? left : -left), angle_rad};
}

Vector2d end_by_angle(const ArcEnds& ends, const Vector2d& center, double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(ends.ccw ? angle_rad : -angle_rad);
    const double x = ends.start.x() - center.x();
    const double y = ends.start.y() - center.y();
    return {center.x() + c * x - s * y, center.y() + s * x + c * y};
}

Result<double> arc_angle_rad(double degrees) {
    if (!(degrees > 0 && degrees <= 360))
        return Unexpected("AR= must be an angle above 0 and up to 360 degrees");
    return degrees * kRadPerDeg;
}

Result<double> additional_turns_rad(double turns, const ArcRules& rules) {
    const double rounded_turns = std::floor(turns + 0.5);
    if (!(std::abs(turns - rounded_turns) <= rules.turns_tolerance) || rounded_turns < 1) {
        return Unexpected("P of an arc (number of turns) must be an integer of at least 1");
    }
    return (rounded_turns - 1) * kTurn_rad;
}

}  // namespace gsim::script
