#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "motion/kinematics/kinematics.h"

namespace gsim::kinematics {

class Chain;

/// Joint values that bring the tool to a pose, or its axis alone.
struct Solution {
    rrs::JointPos joints;
    bool exact = true;  ///< All of the pose is reached.
};

/// What inverse() and solutions() cannot work with, as a sentence: what is no pose (check_pose), or another
/// number of joints.
std::optional<std::string> find_fault(const Chain& chain, const rrs::CartPos& pose,
                                      const rrs::JointPos& near);

/// Whether a machine with these joints may have these ranges: one for each, min not above max; no ranges at
/// all: unlimited. The error is a sentence.
std::optional<std::string> find_fault(const Chain& chain, const std::vector<JointRange>& ranges);

/// Turns the revolute joints of a solution by whole turns towards `near`: as close to it as the ranges let
/// them, or where no turn is in range, to within half a turn.
void turn_near(const Chain& chain, const std::vector<JointRange>& ranges, const rrs::JointPos& near,
               rrs::JointPos& joints);

/// Whether all joints are in range, but for 1e-9 mm or rad.
bool in_range(const std::vector<JointRange>& ranges, const rrs::JointPos& joints);

/// The joint values of solutions in the order of Kinematics::solutions(); those that are equal (to 1e-6) but
/// for whole turns once.
std::vector<rrs::JointPos> in_order(const Chain& chain, const std::vector<JointRange>& ranges,
                                    const rrs::JointPos& near, std::vector<Solution> solutions);

}  // namespace gsim::kinematics
