#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "motion/kinematics/kinematics.h"

namespace gsim::kinematics {

class Chain;

/// Joint values that bring the tool, or only its axis, to a pose.
struct Solution {
    rrs::JointPos joints;
    bool exact = true;  ///< All of the pose is reached.
};

/// Returns a message if inverse() and solutions() cannot use the arguments: `pose` is no pose (check_pose),
/// or the number of joints is different.
std::optional<std::string> find_error(const Chain& chain, const rrs::CartPos& pose,
                                      const rrs::JointPos& near);

/// Returns a message if a machine with these joints cannot have these ranges. Each joint needs one, with min
/// not above max; no ranges at all means unlimited.
std::optional<std::string> find_error(const Chain& chain, const std::vector<JointRange>& ranges);

/// Turns the revolute joints of a solution by full turns towards `near`: as close to it as the ranges allow,
/// or to within half a turn if no turn is in range.
void unwrap_near(const Chain& chain, const std::vector<JointRange>& ranges, const rrs::JointPos& near,
                 rrs::JointPos& joints);

/// True if all joints are in range, to 1e-9 mm or rad.
bool in_range(const std::vector<JointRange>& ranges, const rrs::JointPos& joints);

/// Returns the joint values of solutions in the order of Kinematics::solutions(). Values that are equal (to
/// 1e-6) except for full turns occur once.
std::vector<rrs::JointPos> sorted_solutions(const Chain& chain, const std::vector<JointRange>& ranges,
                                            const rrs::JointPos& near, std::vector<Solution> solutions);

}  // namespace gsim::kinematics
