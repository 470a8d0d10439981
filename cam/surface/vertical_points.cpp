#include "cam/surface/vertical_points.h"

#include <cmath>

#include "base/units.h"

namespace gsim::surface {

namespace {

constexpr double kVerticalTolerance_deg = 0.02;

bool is_vertical(const JetPoint& at) {
    return tilt_rad(at.axis) < kVerticalTolerance_deg * kRadPerDeg;
}

// Returns the direction of the axis tilt as it approaches the upright orientation from `near` and, before
// that, from `farther_point`.
double extrapolated_azimuth(const JetPoint& is_vertical_point, const JetPoint& near,
                            const JetPoint* farther_point) {
    const double first = azimuth_rad(near.axis);
    if (farther_point == nullptr || is_vertical(*farther_point)) return first;
    const double step_mm = (near.edge_mm - is_vertical_point.edge_mm).norm();
    const double next_step_mm = (farther_point->edge_mm - near.edge_mm).norm();
    if (next_step_mm <= 0 || step_mm > 2 * next_step_mm) return first;
    const double turn = std::remainder(azimuth_rad(farther_point->axis) - first, kTurn_rad);
    return first - turn * step_mm / next_step_mm;
}

}  // namespace

double azimuth_rad(const Vector& axis) {
    return std::atan2(axis.y(), axis.x());
}

double tilt_rad(const Vector& axis) {
    return std::atan2(std::hypot(axis.x(), axis.y()), axis.z());
}

Vector axis_direction(double azimuth_rad, double tilt_rad) {
    return {std::sin(tilt_rad) * std::cos(azimuth_rad), std::sin(tilt_rad) * std::sin(azimuth_rad),
            std::cos(tilt_rad)};
}

void split_vertical_points(std::vector<JetPoint>& points) {
    constexpr double kSingularityTilt_rad = kSingularityTilt_deg * kRadPerDeg;
    std::vector<JetPoint> split_points;
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
        JetPoint at = points[i];
        const bool is_vertical_point = is_vertical(at);
        const bool arrives_tilted = is_vertical_point && i > 0 && !is_vertical(points[i - 1]);
        const bool leaves_tilted = is_vertical_point && i + 1 < count && !is_vertical(points[i + 1]);
        at.is_fixed = at.is_fixed || arrives_tilted || leaves_tilted;
        if (arrives_tilted) {
            const JetPoint* farther_point = i > 1 ? &points[i - 2] : nullptr;
            at.axis =
                axis_direction(extrapolated_azimuth(at, points[i - 1], farther_point), kSingularityTilt_rad);
            split_points.push_back(at);
        }
        if (leaves_tilted) {
            const JetPoint* farther_point = i + 2 < count ? &points[i + 2] : nullptr;
            at.axis =
                axis_direction(extrapolated_azimuth(at, points[i + 1], farther_point), kSingularityTilt_rad);
        }
        if (leaves_tilted || !arrives_tilted) split_points.push_back(at);
    }
    points = std::move(split_points);
}

}  // namespace gsim::surface
