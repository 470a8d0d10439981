#include "motion/path/arc_limits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gsim::motion {

namespace {

constexpr double kJerkShare = 1 / (1 + std::numbers::sqrt2);

/// Orientation of a position joint relative to an arc.
struct JointOnArc {
    int joint;
    double plane_share;  ///< Length of its direction in the arc's plane.
    double tangential;   ///< Its largest change per path length that comes from the turn
    double ascent;       ///< and that from the lift.
};

template <typename Visitor>
void for_each_joint(const PlannerSetup& setup, const Arc& arc, const Visitor& visit) {
    const Eigen::Vector3d ascent = (arc.lift / arc.length_mm()).cwiseAbs();
    const Eigen::Vector3d shares = arc.max_shares();
    for (int axis = 0; axis < 3; ++axis) {
        const int joint = setup.position_joints[static_cast<std::size_t>(axis)];
        const double plane_share = std::hypot(arc.u[axis], arc.v[axis]);
        if (joint >= 0 && plane_share >= kMinShare)
            visit(JointOnArc{joint, plane_share, shares[axis] - ascent[axis], ascent[axis]});
    }
}

const JointSetup& limits_of(const PlannerSetup& setup, const JointOnArc& on) {
    return setup.joints[static_cast<std::size_t>(on.joint)];
}

void limit_by_rotation(double jerk, double curvature, double third, LimitCause by, MasterPath& master) {
    master.limit_speed(std::cbrt(jerk / third), by);
    const double acceleration = jerk / (3 * curvature * master.limits.max_speed);
    master.limit_acceleration(acceleration, by);
    master.limit_deceleration(acceleration);
}

}  // namespace

void limit_by_arc_jerk(const PlannerSetup& setup, const Arc& arc, MasterPath& master) {
    if (!setup.controller.ramps.limit_jerk) return;
    const double curvature = arc.max_curvature();
    // This also holds for spirals: p''' is as long as curvature^2 divided by the share of the path that runs
    // round.
    const double third = curvature * curvature / arc.tangent(0).dot(arc.v);
    double turning_jerk = kUnlimited;
    LimitCause by;
    for_each_joint(setup, arc, [&](const JointOnArc& on) {
        const double jerk = kJerkShare * limits_of(setup, on).max_jerk;
        const LimitCause by_joint{LimitKind::jerk, static_cast<std::int8_t>(on.joint)};
        master.limit_jerk(jerk / (on.tangential + on.ascent), by_joint);
        if (jerk / on.plane_share >= turning_jerk) return;
        turning_jerk = jerk / on.plane_share;
        by = by_joint;
    });
    if (std::isfinite(turning_jerk)) limit_by_rotation(turning_jerk, curvature, third, by, master);
}

// Solves (A - ascent a)^2 = (tangential a)^2 + (centripetal_share A)^2 for a.
void limit_by_oblique_helix(const PlannerSetup& setup, const Arc& arc, double centripetal_share,
                            MasterPath& master) {
    const double remaining = 1 - centripetal_share * centripetal_share;
    for_each_joint(setup, arc, [&](const JointOnArc& on) {
        if (on.ascent < kMinShare) return;
        const double square = on.ascent * on.ascent;
        const double share =
            (on.ascent + std::sqrt(square + (on.tangential * on.tangential - square) * remaining)) /
            remaining;
        const double acceleration = limits_of(setup, on).min_acceleration() / share;
        master.limit_acceleration(acceleration,
                                  {LimitKind::acceleration, static_cast<std::int8_t>(on.joint)});
        master.limit_deceleration(acceleration);
    });
}

}  // namespace gsim::motion
