#pragma once

#include <numbers>
#include <random>

#include "analysis/envelope/tcp_chain.h"

namespace gsim::envelope {

inline constexpr double kPi = std::numbers::pi;

inline TcpJoint turn(int joint, const Vector3d& point, const Vector3d& direction, double low = -kPi,
                     double high = kPi) {
    return {joint, rrs::JointKind::revolute, point, direction, low, high};
}

inline TcpJoint slide(int joint, const Vector3d& direction, double low, double high) {
    return {joint, rrs::JointKind::prismatic, Vector3d::Zero(), direction, low, high};
}

/// Two joints about Y, 300 mm and 200 mm long, in the plane XZ.
inline TcpChain planar_arm(double low = -kPi, double high = kPi) {
    return {{turn(0, Vector3d::Zero(), Vector3d::UnitY(), low, high),
             turn(1, {300, 0, 0}, Vector3d::UnitY(), low, high)},
            {500, 0, 0}};
}

/// The same on a joint about Z.
inline TcpChain elbow_arm() {
    TcpChain arm = planar_arm();
    arm.joints.insert(arm.joints.begin(), turn(2, Vector3d::Zero(), Vector3d::UnitZ()));
    return arm;
}

inline Vector3d random_tip(const TcpChain& chain, std::mt19937& random) {
    std::vector<double> values;
    for (const TcpJoint& joint : chain.joints)
        values.push_back(std::uniform_real_distribution<>(joint.low, joint.high)(random));
    return chain.tcp(values);
}

}  // namespace gsim::envelope
