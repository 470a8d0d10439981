#include "motion/path/arc_limits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gsim::motion {

namespace {

constexpr double kPartOfJerk = 1 / (1 + std::numbers::sqrt2);

/// Orientation of a position joint relative to an arc.
struct JointOnArc {
    int joint;
    double across;  ///< Length of its direction in the arc's plane.
    double around;  ///< Its largest change per path length that comes from the turn
    double climb;   ///< and that from the lift.
};

template <typename Take>
void for_each_joint(const PlannerSetup& setup, const Arc& arc, const Take& take) {
    const Eigen::Vector3d climb = (arc.lift / arc.length_mm()).cwiseAbs();
    const Eigen::Vector3d shares = arc.max_shares();
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        const double across = std::hypot(arc.u[axis], arc.v[axis]);
        if (joint >= 0 && across >= kNoShare)
            take(JointOnArc{joint, across, shares[axis] - climb[axis], climb[axis]});
    }
}

const JointSetup& limits_of(const PlannerSetup& setup, const JointOnArc& on) {
    return setup.joints[static_cast<std::size_t>(on.joint)];
}

void limit_by_turning(double jerk, double curvature, double third, LimitedBy by, LeadPath& lead) {
    lead.limit_speed(std::cbrt(jerk / third), by);
    const double acceleration = jerk / (3 * curvature * lead.limits.max_speed);
    lead.limit_acceleration(acceleration, by);
    lead.limit_deceleration(acceleration);
}

}  // namespace

void limit_by_arc_jerk(const PlannerSetup& setup, const Arc& arc, LeadPath& lead) {
    if (!setup.controller.limit_jerk) return;
    const double curvature = arc.max_curvature();
    // This also holds for spirals: p''' is as long as curvature^2 divided by the share of the path that runs
    // round.
    const double third = curvature * curvature / arc.tangent(0).dot(arc.v);
    double turning = kUnlimited;
    LimitedBy by;
    for_each_joint(setup, arc, [&](const JointOnArc& on) {
        const double jerk = kPartOfJerk * limits_of(setup, on).max_jerk;
        const LimitedBy by_joint{LimitKind::jerk, static_cast<std::int8_t>(on.joint)};
        lead.limit_jerk(jerk / (on.around + on.climb), by_joint);
        if (jerk / on.across >= turning) return;
        turning = jerk / on.across;
        by = by_joint;
    });
    if (std::isfinite(turning)) limit_by_turning(turning, curvature, third, by, lead);
}

// Solves (A - climb a)^2 = (around a)^2 + (share A)^2 for a.
void limit_by_askew_climb(const PlannerSetup& setup, const Arc& arc, double centripetal_share,
                          LeadPath& lead) {
    const double left = 1 - centripetal_share * centripetal_share;
    for_each_joint(setup, arc, [&](const JointOnArc& on) {
        if (on.climb < kNoShare) return;
        const double square = on.climb * on.climb;
        const double share = (on.climb + std::sqrt(square + (on.around * on.around - square) * left)) / left;
        const double acceleration = limits_of(setup, on).least_acceleration() / share;
        lead.limit_acceleration(acceleration, {LimitKind::acceleration, static_cast<std::int8_t>(on.joint)});
        lead.limit_deceleration(acceleration);
    });
}

}  // namespace gsim::motion
