#include "motion/path/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.h"

namespace gsim::motion {

namespace {

using Eigen::Vector3d;

// The path by its own length s: radius = start radius + radial s, radius dphi/ds = tangential,
// lift = ascent s. The three are constant and radial^2 + tangential^2 + ascent^2 = 1.
struct ArcSlopes {
    double radial;
    double tangential;
    Vector3d ascent;
    double length_mm;
};

// Returns log(end radius / start radius), exact for small differences.
double log_growth(const Arc& arc) {
    return std::log1p((arc.end_radius_mm - arc.radius_mm) / arc.radius_mm);
}

// Returns the length of a spiral's path around, by its angle: change of radius / log_growth(), which is 0 / 0
// on a circle. Programs round their centres, so most arcs are spirals by a very small amount. The series is
// exact and cheap for them.
double mean_radius(const Arc& arc) {
    constexpr double kMinGrowth = 1e-4;  // the next term is below 3 % of its fourth power
    const double growth = (arc.end_radius_mm - arc.radius_mm) / arc.radius_mm;
    if (std::abs(growth) > kMinGrowth) return (arc.end_radius_mm - arc.radius_mm) / log_growth(arc);
    return arc.radius_mm * (1 + growth * (1.0 / 2 - growth * (1.0 / 12 - growth / 24)));
}

ArcSlopes arc_slopes(const Arc& arc) {
    const double change = arc.end_radius_mm - arc.radius_mm;
    const double arc_length_mm = arc.sweep_rad * mean_radius(arc);
    const double length = std::sqrt(change * change + arc_length_mm * arc_length_mm + arc.lift.squaredNorm());
    return {change / length, arc_length_mm / length, arc.lift / length, length};
}

// Returns the angle at a share of the path from 0 to 1; share_at() is the inverse.
double phi_at_share(const Arc& arc, double share) {
    const double change = arc.end_radius_mm - arc.radius_mm;
    if (change == 0) return arc.sweep_rad * share;
    return arc.sweep_rad * std::log1p(change / arc.radius_mm * share) / log_growth(arc);
}

double share_at(const Arc& arc, double phi_rad) {
    const double angle_share = phi_rad / arc.sweep_rad;
    const double change = arc.end_radius_mm - arc.radius_mm;
    if (change == 0) return angle_share;
    return std::expm1(angle_share * log_growth(arc)) * arc.radius_mm / change;
}

double radius_at_share(const Arc& arc, double share) {
    return arc.radius_mm + (arc.end_radius_mm - arc.radius_mm) * share;
}

double radius_at(const Arc& arc, double phi_rad) {
    return radius_at_share(arc, share_at(arc, phi_rad));
}

// Returns the length of a vector in the plane with components of about size 1. std::hypot() guards against
// overflow, which is not needed here.
double in_plane(double x, double y) {
    return std::sqrt(x * x + y * y);
}

// Unit vectors at an angle: away from the centre, and around it in the direction of travel.
struct Directions {
    Directions(const Arc& arc, double phi_rad)
        : cosine(std::cos(phi_rad)),
          sine(std::sin(phi_rad)),
          outward_direction(cosine * arc.u + sine * arc.v),
          forward(cosine * arc.v - sine * arc.u) {}
    double cosine;
    double sine;
    Vector3d outward_direction;
    Vector3d forward;
};

// Widens the range by the coordinate at the angles `phase` + 2 pi k within the sweep. The value drifts in one
// direction from turn to turn, so the first and the last of them suffice.
void expand(Range& range, const Arc& arc, int axis, double phase) {
    const double first = phase - kTurn_rad * std::floor(phase / kTurn_rad);
    if (first >= arc.sweep_rad) return;
    const double last = first + kTurn_rad * std::floor((arc.sweep_rad - first) / kTurn_rad);
    for (const double phi : {first, last}) {
        const double value = arc.at(phi)[axis];
        range.min = std::min(range.min, value);
        range.max = std::max(range.max, value);
    }
}

}  // namespace

double Arc::length_mm() const {
    return arc_slopes(*this).length_mm;
}

double Arc::phi_at(double s_mm) const {
    return phi_at_share(*this, s_mm / length_mm());
}

double Arc::length_to(double phi_rad) const {
    return length_mm() * share_at(*this, phi_rad);
}

Arc Arc::part(double from_mm, double to_mm) const {
    const double length = length_mm();
    const double from_share = from_mm / length;
    const double to_share = to_mm / length;
    const double from_rad = phi_at_share(*this, from_share);
    const Directions from(*this, from_rad);
    Arc part = *this;
    part.center += from_share * lift;
    part.u = from.outward_direction;
    part.v = from.forward;
    part.radius_mm = radius_at_share(*this, from_share);
    part.end_radius_mm = radius_at_share(*this, to_share);
    part.sweep_rad = phi_at_share(*this, to_share) - from_rad;
    part.lift = (to_share - from_share) * lift;
    return part;
}

Vector3d Arc::at(double phi_rad) const {
    const double share = share_at(*this, phi_rad);
    const Vector3d outward_direction = std::cos(phi_rad) * u + std::sin(phi_rad) * v;
    return center + radius_at_share(*this, share) * outward_direction + share * lift;
}

Vector3d Arc::tangent(double phi_rad) const {
    const ArcSlopes slopes = arc_slopes(*this);
    const Directions at(*this, phi_rad);
    return slopes.radial * at.outward_direction + slopes.tangential * at.forward + slopes.ascent;
}

Vector3d Arc::curvature(double phi_rad) const {
    const ArcSlopes slopes = arc_slopes(*this);
    const Directions at(*this, phi_rad);
    return slopes.tangential / radius_at(*this, phi_rad) *
           (slopes.radial * at.forward - slopes.tangential * at.outward_direction);
}

double Arc::max_curvature() const {
    const ArcSlopes slopes = arc_slopes(*this);
    return slopes.tangential * in_plane(slopes.tangential, slopes.radial) /
           std::min(radius_mm, end_radius_mm);
}

double Arc::max_share(int axis) const {
    return max_shares()[axis];
}

Vector3d Arc::max_shares() const {
    const ArcSlopes slopes = arc_slopes(*this);
    const double in_plane_share = in_plane(slopes.tangential, slopes.radial);
    Vector3d shares;
    for (int axis = 0; axis < 3; ++axis)
        shares[axis] = in_plane_share * in_plane(u[axis], v[axis]) + std::abs(slopes.ascent[axis]);
    return shares;
}

Range Arc::bounds(int axis) const {
    const double reach = std::max(radius_mm, end_radius_mm);
    return {center[axis] - reach + std::min(0.0, lift[axis]),
            center[axis] + reach + std::max(0.0, lift[axis])};
}

// A curve deviates from the straight line between its ends by at most 1/8 of its largest second derivative,
// times the square of the interval. That of a logarithmic spiral is radius (1 + (log growth / sweep)^2).
double Arc::bulge_mm() const {
    const double growth = (end_radius_mm - radius_mm) / std::min(radius_mm, end_radius_mm);
    return std::max(radius_mm, end_radius_mm) * (sweep_rad * sweep_rad + growth * growth) / 8;
}

// The coordinate's slope, with psi = phi - atan2(v, u), is
// in_plane(u, v) (radial cos psi - tangential sin psi) + ascent
// = ascent - amplitude sin(psi - atan2(radial, tangential)).
Range Arc::range(int axis) const {
    const double start = center[axis] + radius_mm * u[axis];
    const double end = at(sweep_rad)[axis];
    Range range{std::min(start, end), std::max(start, end)};
    const ArcSlopes slopes = arc_slopes(*this);
    const double amplitude = in_plane(u[axis], v[axis]) * in_plane(slopes.tangential, slopes.radial);
    if (std::abs(slopes.ascent[axis]) >= amplitude) return range;
    const double base = std::atan2(v[axis], u[axis]) + std::atan2(slopes.radial, slopes.tangential);
    const double turn = std::asin(slopes.ascent[axis] / amplitude);
    expand(range, *this, axis, base + turn);
    expand(range, *this, axis, base + std::numbers::pi - turn);
    return range;
}

}  // namespace gsim::motion
