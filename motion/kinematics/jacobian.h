#pragma once

#include <vector>

#include "motion/kinematics/chain.h"

namespace gsim::kinematics {

/// A matrix with six rows and a column for each joint.
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, rrs::kMaxJoints>;
using Twist = Eigen::Matrix<double, 6, 1>;

/// Where a chain stands, and how its joints move the tool against the work from there.
struct Stance {
    rrs::CartPos tool;  ///< In the world.
    rrs::CartPos work;
    /// Speed of the tool's tip (rows 0 to 2, mm) and its turning (rows 3 to 5, rad) against the work, in
    /// directions of the world, for each unit (mm or rad) of a joint's speed.
    Jacobian jacobian;
};

Stance stance(const Chain& chain, const rrs::JointPos& joints);

/// What takes the tool to `pose` (in the work frame): the way in mm, then the rotation vector in rad, in
/// directions of the world.
Twist twist_to(const Stance& stance, const rrs::CartPos& pose);

/// How many mm of the tip's way weigh as much as a radian: about as far as the chain reaches; > 0.
double mm_per_rad(const Chain& chain);

/// The joints that line up at a singular stance: those that can move against each other while the tool
/// stands, where the chain has as many joints as that takes it to be none elsewhere; empty where the stance
/// is not singular (least singular value of the Jacobian, with lengths in units of `mm_per_rad`, at least
/// `threshold`).
std::vector<int> lined_up(const Stance& stance, double mm_per_rad, double threshold);

}  // namespace gsim::kinematics
