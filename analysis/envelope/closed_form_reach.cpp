#include "analysis/envelope/closed_form_reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/envelope/closest_approach.h"

namespace gsim::envelope {

namespace {

constexpr double kOrthogonal = 1e-12;
constexpr double kFullTurn_rad = 2 * std::numbers::pi;

bool is_orthogonal_to(const TcpJoint& slide, const std::vector<TcpJoint>& others) {
    return std::all_of(others.begin(), others.end(), [&](const TcpJoint& other) {
        return std::abs(slide.direction.dot(other.direction)) < kOrthogonal;
    });
}

}  // namespace

ClosedFormReach::ClosedFormReach(const TcpChain& chain) : tail_{{}, chain.start_mm} {
    for (auto joint = chain.joints.rbegin(); joint != chain.joints.rend(); ++joint) {
        if (!joint->is_slide()) {
            if (tail_.joints.empty()) tail_.joints.push_back(*joint);
            return;
        }
        if (!is_orthogonal_to(*joint, tail_.joints)) return;
        tail_.joints.insert(tail_.joints.begin(), *joint);
    }
}

double ClosedFormReach::nearest_angle(const Vector3d& point) const {
    const TcpJoint& joint = tail_.joints.front();
    const Vector3d arm = tail_.start_mm - joint.point_mm;
    const Vector3d out = arm - arm.dot(joint.direction) * joint.direction;
    const Vector3d to = point - joint.point_mm;
    const double angle = std::atan2(joint.direction.cross(out).dot(to), out.dot(to));
    const double raised = angle + kFullTurn_rad * std::ceil((joint.low - angle) / kFullTurn_rad);
    if (raised <= joint.high) return raised;
    // Beyond the ends the nearer one counts, by the shorter turn.
    return raised - joint.high < kFullTurn_rad - (raised - joint.low) ? joint.high : joint.low;
}

std::vector<double> ClosedFormReach::nearest_values(const Vector3d& point) const {
    if (tail_.joints.size() == 1 && !tail_.joints.front().is_slide()) return {nearest_angle(point)};
    std::vector<double> values;
    values.reserve(tail_.joints.size());
    for (const TcpJoint& slide : tail_.joints)
        values.push_back(std::clamp((point - tail_.start_mm).dot(slide.direction), slide.low, slide.high));
    return values;
}

double ClosedFormReach::distance_mm(const Vector3d& point) const {
    if (tail_.joints.size() == 1 && !tail_.joints.front().is_slide())
        return (point - tail_.joints.front().transformed(tail_.start_mm, nearest_angle(point))).norm();
    Vector3d remaining = point - tail_.start_mm;
    for (const TcpJoint& slide : tail_.joints)
        remaining -= std::clamp(remaining.dot(slide.direction), slide.low, slide.high) * slide.direction;
    return remaining.norm();
}

Eigen::AlignedBox3d ClosedFormReach::bounds() const {
    Eigen::AlignedBox3d box(tail_.start_mm);
    for (const TcpJoint& joint : tail_.joints) box = swept_box(joint, box);
    return box;
}

}  // namespace gsim::envelope
