#pragma once

#include <numbers>
#include <vector>

#include "motion/kinematics/chain_kinematics.h"

namespace gsim::kinematics {

constexpr double kQuarter = std::numbers::pi / 2;

inline DhLink slide(double theta_rad, double alpha_rad) {
    return {.kind = rrs::JointKind::prismatic, .theta_rad = theta_rad, .alpha_rad = alpha_rad};
}

inline DhLink turn(double theta_rad, double alpha_rad) {
    return {.kind = rrs::JointKind::revolute, .theta_rad = theta_rad, .alpha_rad = alpha_rad};
}

/// Returns x0 = +Z, y0 = -Y, z0 = +X of the world, so that the first slide moves along X.
inline rrs::CartPos gantry_base() {
    rrs::CartPos base = rrs::CartPos::Identity();
    base.linear().col(0) = Eigen::Vector3d::UnitZ();
    base.linear().col(1) = -Eigen::Vector3d::UnitY();
    base.linear().col(2) = Eigen::Vector3d::UnitX();
    return base;
}

/// Returns slides along X, Y, Z, then B about the vertical and C tilting, both through the TCP.
inline std::vector<DhLink> gantry_rows() {
    return {slide(0, kQuarter), slide(kQuarter, kQuarter), slide(0, 0), turn(0, -kQuarter),
            turn(0, kQuarter)};
}

inline DhChain standard_gantry() {
    return DhChain(gantry_base(), gantry_rows(), rrs::CartPos::Identity());
}

inline rrs::JointPos joint_pos(std::initializer_list<double> values) {
    rrs::JointPos joints(static_cast<Eigen::Index>(values.size()));
    Eigen::Index index = 0;
    for (const double value : values) joints[index++] = value;
    return joints;
}

}  // namespace gsim::kinematics
