#include "cam/surface/upright.h"

#include <cmath>

#include "base/units.h"

namespace gsim::surface {

namespace {

constexpr double kUpright_deg = 0.02;

bool is_upright(const JetPoint& at) {
    return lean_rad(at.axis) < kUpright_deg * kRadPerDeg;
}

// Returns the direction of the axis tilt as it approaches the upright orientation from `near` and, before
// that, from `far`.
double azimuth_beside(const JetPoint& upright, const JetPoint& near, const JetPoint* far) {
    const double first = azimuth_rad(near.axis);
    if (far == nullptr || is_upright(*far)) return first;
    const double step_mm = (near.edge_mm - upright.edge_mm).norm();
    const double next_mm = (far->edge_mm - near.edge_mm).norm();
    if (next_mm <= 0 || step_mm > 2 * next_mm) return first;
    const double turn = std::remainder(azimuth_rad(far->axis) - first, kTurn_rad);
    return first - turn * step_mm / next_mm;
}

}  // namespace

double azimuth_rad(const Vector& axis) {
    return std::atan2(axis.y(), axis.x());
}

double lean_rad(const Vector& axis) {
    return std::atan2(std::hypot(axis.x(), axis.y()), axis.z());
}

Vector axis_of(double azimuth_rad, double lean_rad) {
    return {std::sin(lean_rad) * std::cos(azimuth_rad), std::sin(lean_rad) * std::sin(azimuth_rad),
            std::cos(lean_rad)};
}

void settle_upright(std::vector<JetPoint>& points) {
    constexpr double kHair_rad = kHair_deg * kRadPerDeg;
    std::vector<JetPoint> settled;
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
        JetPoint at = points[i];
        const bool upright = is_upright(at);
        const bool came_leaning = upright && i > 0 && !is_upright(points[i - 1]);
        const bool goes_leaning = upright && i + 1 < count && !is_upright(points[i + 1]);
        at.stays = at.stays || came_leaning || goes_leaning;
        if (came_leaning) {
            const JetPoint* far = i > 1 ? &points[i - 2] : nullptr;
            at.axis = axis_of(azimuth_beside(at, points[i - 1], far), kHair_rad);
            settled.push_back(at);
        }
        if (goes_leaning) {
            const JetPoint* far = i + 2 < count ? &points[i + 2] : nullptr;
            at.axis = axis_of(azimuth_beside(at, points[i + 1], far), kHair_rad);
        }
        if (goes_leaning || !came_leaning) settled.push_back(at);
    }
    points = std::move(settled);
}

}  // namespace gsim::surface
