#pragma once

#include <Eigen/Core>
#include <vector>

#include "motion/kinematics/chain.h"

namespace gsim::kinematics {

/// Sine of the angle below which two directions count as parallel.
inline constexpr double kParallel = 1e-9;

/// A joint's axis in the world with all joints at zero, and the sense in which its value moves the tool
/// against the work.
struct Screw {
    int joint = 0;
    rrs::JointKind kind = rrs::JointKind::prismatic;
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< On the axis, mm.
};

/// A chain as a product of exponentials (Murray, Li, Sastry: A Mathematical Introduction to Robotic
/// Manipulation, 1994, section 3.2). With W and T the work and tool frames at zero, the tool's pose in the
/// work frame is W^-1 exp(s1 q1) ... exp(sn qn) T. Joints of the work's side come first, the one next to the
/// work before all, with their directions reversed: they move the world against the work.
struct ScrewChain {
    std::vector<Screw> screws;
    rrs::CartPos work_at_zero;
    rrs::CartPos tool_at_zero;
};

ScrewChain screw_chain(const Chain& chain);

}  // namespace gsim::kinematics
