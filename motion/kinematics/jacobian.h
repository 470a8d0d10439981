#pragma once

#include <vector>

#include "motion/kinematics/chain.h"

namespace gsim::kinematics {

/// A matrix with six rows and a column for each joint.
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, rrs::kMaxJoints>;
using Twist = Eigen::Matrix<double, 6, 1>;

/// Configuration of a chain, and the motion of the tool relative to the work that its joints cause from
/// there.
struct Configuration {
    rrs::CartPos tool;  ///< In the world.
    rrs::CartPos work;
    /// Speed of the TCP (rows 0 to 2, mm) and turning of the tool (rows 3 to 5, rad) relative to the work,
    /// for each unit (mm or rad) of a joint's speed. Directions are those of the world.
    Jacobian jacobian;
};

Configuration configuration(const Chain& chain, const rrs::JointPos& joints);

/// Returns the motion that takes the tool to `pose` (in the work frame): the displacement in mm, then the
/// rotation vector in rad, in world directions.
Twist twist_to_pose(const Configuration& configuration, const rrs::CartPos& pose);

/// Returns the TCP distance in mm that weighs as much as a radian: about the reach of the chain; > 0.
double mm_per_rad(const Chain& chain);

/// Returns the joints that line up at a singular configuration: those that can move against each other while
/// the tool is at standstill. The chain must have only so many joints that none can do so elsewhere. Returns
/// an empty list if the configuration is not singular: the smallest singular value of the Jacobian, with
/// lengths in units of `mm_per_rad`, is at least `threshold`.
std::vector<int> aligned_joints(const Configuration& configuration, double mm_per_rad, double threshold);

}  // namespace gsim::kinematics
