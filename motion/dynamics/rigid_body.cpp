#include "motion/dynamics/rigid_body.h"

#include <fmt/format.h>

#include "base/dense/symmetric.h"

namespace gsim::dynamics {

namespace {

constexpr double kRounding = 1e-9;  // of the greatest moment: figures of files are rounded

// Returns the contribution of a mass away from the axes (Steiner).
Eigen::Matrix3d point_mass_inertia(double mass_kg, const Eigen::Vector3d& point_m) {
    return mass_kg * (point_m.squaredNorm() * Eigen::Matrix3d::Identity() - point_m * point_m.transpose());
}

}  // namespace

RigidBody moved(const RigidBody& body, const Eigen::Isometry3d& pose) {
    const Eigen::Matrix3d turn = pose.linear();
    return {.mass_kg = body.mass_kg,
            .centre_m = pose * body.centre_m,
            .inertia_kg_m2 = turn * body.inertia_kg_m2 * turn.transpose()};
}

RigidBody joined(const RigidBody& a, const RigidBody& b) {
    const double mass_kg = a.mass_kg + b.mass_kg;
    if (!(mass_kg > 0)) return a;
    const Eigen::Vector3d centre_m = (a.mass_kg * a.centre_m + b.mass_kg * b.centre_m) / mass_kg;
    return {.mass_kg = mass_kg,
            .centre_m = centre_m,
            .inertia_kg_m2 = a.inertia_kg_m2 + point_mass_inertia(a.mass_kg, a.centre_m - centre_m) +
                             b.inertia_kg_m2 + point_mass_inertia(b.mass_kg, b.centre_m - centre_m)};
}

std::optional<std::string> find_inertia_error(const Eigen::Matrix3d& inertia_kg_m2) {
    const Eigen::Vector3d moments = base::symmetric_eigenvalues(inertia_kg_m2);
    const double rounding = kRounding * moments.cwiseAbs().maxCoeff();
    if (moments[0] < -rounding)
        return fmt::format("one of its principal moments is negative: {:.6g} kg m2", moments[0]);
    if (moments[2] > moments[0] + moments[1] + rounding) {
        return fmt::format(
            "its principal moment {:.6g} kg m2 is greater than the sum of the two others, {:.6g} and {:.6g}",
            moments[2], moments[0], moments[1]);
    }
    return std::nullopt;
}

}  // namespace gsim::dynamics
