#pragma once

#include <random>

#include "motion/dynamics/dynamics.h"
#include "tests/motion/kinematics/chains.h"

namespace gsim::dynamics {

using kinematics::Branch;
using kinematics::Chain;
using kinematics::joint_pos;
using kinematics::Link;

/// Returns a joint at `at` (mm) of the preceding frame that moves along or about `direction`.
inline Link joint(int index, rrs::JointKind kind, const Eigen::Vector3d& direction,
                  const Eigen::Vector3d& at = Eigen::Vector3d::Zero()) {
    rrs::CartPos position = rrs::CartPos::Identity();
    position.linear() =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), direction).toRotationMatrix();
    rrs::CartPos back = rrs::CartPos::Identity();
    back.linear() = position.linear().transpose();
    position.translation() = at;
    return {.joint = index, .kind = kind, .before = position, .after = back};
}

inline DynamicsModel model_of(std::vector<RigidBody> links) {
    DynamicsModel model;
    model.drives.resize(links.size());
    model.links = std::move(links);
    return model;
}

inline RigidBody point_mass(double mass_kg, const Eigen::Vector3d& at_m = Eigen::Vector3d::Zero()) {
    return {.mass_kg = mass_kg, .centre_m = at_m};
}

/// Random values from a seed.
class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}

    double from(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    Eigen::Vector3d vector(double max) { return {from(-max, max), from(-max, max), from(-max, max)}; }
    Eigen::Matrix3d turn() {
        return Eigen::Quaterniond(from(-1, 1), from(-1, 1), from(-1, 1), from(-1, 1))
            .normalized()
            .toRotationMatrix();
    }
    rrs::CartPos pose(double greatest_mm) {
        rrs::CartPos pose = rrs::CartPos::Identity();
        pose.linear() = turn();
        pose.translation() = vector(greatest_mm);
        return pose;
    }
    rrs::JointPos joints(int count, double max) {
        rrs::JointPos values(count);
        for (double& value : values) value = from(-max, max);
        return values;
    }
    /// Returns a box of even density in any orientation.
    RigidBody body() {
        const double mass_kg = from(0.5, 40);
        const Eigen::Vector3d size_m = vector(0.4).cwiseAbs();
        const Eigen::Vector3d squares = size_m.cwiseAbs2();
        const Eigen::Vector3d moments = mass_kg / 12 * (Eigen::Vector3d::Constant(squares.sum()) - squares);
        const Eigen::Matrix3d axes = turn();
        return {.mass_kg = mass_kg,
                .centre_m = vector(0.3),
                .inertia_kg_m2 = axes * moments.asDiagonal() * axes.transpose()};
    }
    /// Returns joints of both kinds at any positions, some of which carry the work.
    Chain chain(int tool_joints, int work_joints) {
        Branch tool{.base = pose(500), .end = pose(100)};
        Branch work{.base = pose(500), .end = pose(100)};
        for (int i = 0; i < tool_joints + work_joints; ++i) {
            const auto kind = from(0, 1) < 0.5 ? rrs::JointKind::prismatic : rrs::JointKind::revolute;
            (i < tool_joints ? tool : work)
                .links.push_back({.joint = i, .kind = kind, .before = pose(300), .after = pose(200)});
        }
        return Chain(std::move(tool), std::move(work));
    }
    /// With all that a model can have.
    DynamicsModel model(int joints) {
        DynamicsModel model;
        model.gravity_m_s2 = vector(10);
        for (int i = 0; i < joints; ++i) {
            model.links.push_back(body());
            model.drives.push_back({.coulomb_friction = from(0, 30),
                                    .viscous = from(0, 20),
                                    .rotor = from(0, 5),
                                    .counterweight = from(-50, 50)});
        }
        model.tool = body();
        model.work = body();
        model.hoses.push_back({.end = HoseEnd::tool,
                               .joint = 0,
                               .point_m = vector(0.1),
                               .anchor_m = vector(2),
                               .free_length_m = from(0, 1),
                               .stiffness_n_per_m = from(0, 300),
                               .drag_n_s_per_m = 0});
        return model;
    }

  private:
    std::mt19937 engine_;
};

}  // namespace gsim::dynamics
