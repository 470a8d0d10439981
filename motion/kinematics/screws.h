#pragma once

#include <Eigen/Core>
#include <vector>

#include "motion/kinematics/chain.h"

namespace gsim::kinematics {

/// Sine of the angle below which two directions count as parallel.
inline constexpr double kParallel = 1e-9;

/// Axis of a joint in the world with all joints at zero, and the direction in which its value moves the tool
/// relative to the work.
struct Screw {
    int joint = 0;
    rrs::JointKind kind = rrs::JointKind::prismatic;
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< On the axis, mm.
};

/// Chain as a product of exponentials (Murray, Li, Sastry: A Mathematical Introduction to Robotic
/// Manipulation, 1994, section 3.2). The tool pose in the work frame is W^-1 exp(s1 q1) ... exp(sn qn) T,
/// with W and T the work and tool frames at zero. Joints of the work side come first, starting with the one
/// next to the work. Their directions are reversed, because they move the world relative to the work.
struct ScrewChain {
    std::vector<Screw> screws;
    rrs::CartPos work_at_zero;
    rrs::CartPos tool_at_zero;
};

ScrewChain screw_chain(const Chain& chain);

}  // namespace gsim::kinematics
