#include "analysis/envelope/outline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "analysis/envelope/region.h"

namespace gsim::envelope {

namespace {

constexpr double kFullTurn = 2 * std::numbers::pi - 1e-9;
constexpr int kPointsPerTurn = 180;

// Returns the normal of the plane in which two joints keep the TCP.
std::optional<Vector3d> plane_normal(const TcpJoint& a, const TcpJoint& b) {
    if (a.is_slide() && b.is_slide()) {
        const Vector3d normal = a.direction.cross(b.direction);
        return normal.norm() < kParallel ? a.direction.unitOrthogonal() : normal.normalized();
    }
    if (!a.is_slide() && !b.is_slide()) {
        if (is_parallel(a.direction, b.direction)) return a.direction;
        return std::nullopt;
    }
    const TcpJoint& slide = a.is_slide() ? a : b;
    const TcpJoint& turn = a.is_slide() ? b : a;
    if (std::abs(slide.direction.dot(turn.direction)) < kParallel) return turn.direction;
    return std::nullopt;
}

Curve parallelogram(const TcpChain& chain) {
    const TcpJoint& a = chain.joints[0];
    const TcpJoint& b = chain.joints[1];
    return {true,
            {chain.tcp({a.low, b.low}), chain.tcp({a.high, b.low}), chain.tcp({a.high, b.high}),
             chain.tcp({a.low, b.high})}};
}

// Returns the path of joint `moving` with the other one at `value`.
Curve reachable_curve(const TcpChain& chain, std::size_t moving, double value) {
    const TcpJoint& joint = chain.joints[moving];
    const int steps = joint.is_slide() ? 1 : kPointsPerTurn;
    Curve curve{!joint.is_slide() && joint.high - joint.low >= kFullTurn, {}};
    const int count = steps + (curve.closed ? 0 : 1);
    curve.points_mm.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        std::vector<double> values(2, value);
        values[moving] = joint.low + (joint.high - joint.low) * i / steps;
        curve.points_mm.push_back(chain.tcp(values));
    }
    return curve;
}

std::vector<Curve> border_paths(const TcpChain& chain) {
    std::vector<Curve> curves;
    curves.reserve(4);
    for (const std::size_t fixed : {std::size_t{0}, std::size_t{1}}) {
        const TcpJoint& joint = chain.joints[fixed];
        if (!joint.is_slide() && joint.high - joint.low >= kFullTurn) continue;
        for (const double value : {joint.low, joint.high})
            curves.push_back(reachable_curve(chain, 1 - fixed, value));
    }
    return curves;
}

PairOutline outline(const TcpChain& chain) {
    const TcpJoint& a = chain.joints[0];
    const TcpJoint& b = chain.joints[1];
    PairOutline result{a.joint, b.joint, false, Vector3d::UnitZ(), 0, {}};
    const auto normal = plane_normal(a, b);
    if (!normal) {
        result.curves = border_paths(chain);
        return result;
    }
    result.flat = true;
    result.normal = *normal;
    if (a.is_slide() && b.is_slide()) {
        result.curves.push_back(parallelogram(chain));
        return result;
    }
    Region region = reached_region(chain, *normal);
    result.error_mm = region.error_mm;
    for (std::vector<Vector3d>& loop : region.loops_mm) result.curves.push_back({true, std::move(loop)});
    return result;
}

}  // namespace

std::vector<PairOutline> pair_outlines(const TcpChain& chain, const rrs::JointPos& home) {
    std::vector<PairOutline> outlines;
    for (std::size_t first = 0; first < chain.joints.size(); ++first) {
        for (std::size_t second = first + 1; second < chain.joints.size(); ++second) {
            const TcpChain pair = pair_chain(chain, first, second, home);
            if (pair.joints.size() == 2) outlines.push_back(outline(pair));
        }
    }
    return outlines;
}

}  // namespace gsim::envelope
