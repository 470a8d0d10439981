#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>

namespace gsim::dynamics {

/// Inertia of a body: mass, centre of mass, and the inertia tensor about that centre, in the axes of some
/// frame. Products of inertia are elements of the tensor: xy is minus the sum of m x y.
struct RigidBody {
    double mass_kg = 0;
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    Eigen::Matrix3d inertia_kg_m2 = Eigen::Matrix3d::Zero();
};

/// Returns the same body seen from a frame in which its own frame is at `pose` (translation in m).
RigidBody moved(const RigidBody& body, const Eigen::Isometry3d& pose);

/// Returns both bodies as one.
RigidBody joined(const RigidBody& a, const RigidBody& b);

/// Returns why no distribution of mass has this tensor, as the end of a message; nothing if one has:
/// principal moments are not negative, and none is more than the sum of the two others.
std::optional<std::string> find_inertia_error(const Eigen::Matrix3d& inertia_kg_m2);

}  // namespace gsim::dynamics
