#include "geometry/distance/convex.h"

#include <algorithm>
#include <cmath>

#include "geometry/distance/simplex.h"

namespace gsim::cell {

using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

constexpr double kExactTolerance_mm = 1e-9;
constexpr int kMaxSteps = 100;

Vector3d placed_support(const Convex& body, const Isometry3d& pose, const Vector3d& direction) {
    return pose * body.support(pose.linear().transpose() * direction);
}

// In an overlap four corners contain the origin, and their weights have no meaning, so any common point will
// do.
DifferencePoint touching_point(const Simplex& simplex, const DifferencePoint& last) {
    return simplex.size() == 4 ? last : simplex.nearest();
}

// Subtracts the margins from the distance between the cores, to get that between the bodies.
Gap subtract_margins(double lower_mm, const DifferencePoint& nearest, double first_margin_mm,
                     double second_margin_mm) {
    const double margins = first_margin_mm + second_margin_mm;
    const Vector3d displacement = nearest.on_second - nearest.on_first;
    const double length = displacement.norm();
    Gap gap{std::max(0.0, lower_mm - margins), std::max(0.0, length - margins), nearest.on_first,
            nearest.on_second};
    if (length > 0) {
        const double share = std::min(1.0, length / std::max(margins, 1e-300));
        gap.on_first += displacement / length * first_margin_mm * share;
        gap.on_second -= displacement / length * second_margin_mm * share;
    }
    return gap;
}

}  // namespace

Vector3d Convex::support(const Vector3d& direction) const {
    if (core == Core::box)
        return half_mm.cwiseProduct(direction.unaryExpr([](double d) { return d < 0 ? -1.0 : 1.0; }));
    if (core == Core::cylinder) {
        const double across = std::hypot(direction.x(), direction.y());
        const double z = direction.z() < 0 ? -half_mm.z() : half_mm.z();
        if (!(across > 0)) return {half_mm.x(), 0, z};
        return {half_mm.x() * direction.x() / across, half_mm.x() * direction.y() / across, z};
    }
    Vector3d best = points[0];
    for (int i = 1; i < point_count; ++i) {
        const Vector3d& point = points[static_cast<std::size_t>(i)];
        if (point.dot(direction) > best.dot(direction)) best = point;
    }
    return best;
}

Vector3d SweptConvex::support(const Vector3d& direction) const {
    Vector3d first = placed_support(body, from, direction);
    if (&from == &to) return first;
    const Vector3d second = placed_support(body, to, direction);
    return second.dot(direction) > first.dot(direction) ? second : first;
}

Gap shape_distance(const SweptConvex& moving, const Convex& fixed, const Isometry3d& fixed_pose,
                   const ShapeDistanceRequest& request) {
    const double margins = moving.body.margin_mm + fixed.margin_mm;
    Vector3d v = moving.from.translation() - fixed_pose.translation();
    if (!(v.squaredNorm() > 0)) v = Vector3d::UnitX();
    Simplex simplex;
    DifferencePoint nearest;
    double lower = 0;
    double square = std::numeric_limits<double>::infinity();
    for (int step = 0; step < kMaxSteps; ++step) {
        DifferencePoint next;
        next.on_first = moving.support(-v);
        next.on_second = placed_support(fixed, fixed_pose, v);
        next.at = next.on_first - next.on_second;
        const double length = v.norm();
        lower = std::max(lower, v.dot(next.at) / length);
        if (simplex.size() == 0) nearest = next;
        if (lower - margins >= request.cutoff_mm) break;
        const double exact = std::max(kExactTolerance_mm, request.relative_tolerance * length);
        if (simplex.size() > 0 && (length - lower <= exact || simplex.contains(next.at))) break;
        simplex.add(next);
        v = simplex.reduce();
        nearest = touching_point(simplex, next);
        const double now = v.squaredNorm();
        if (now <= kExactTolerance_mm * kExactTolerance_mm) return {0, 0, nearest.on_first, nearest.on_first};
        if (now >= square) break;  // rounding leaves no more to gain
        square = now;
    }
    return subtract_margins(lower, nearest, moving.body.margin_mm, fixed.margin_mm);
}

}  // namespace gsim::cell
