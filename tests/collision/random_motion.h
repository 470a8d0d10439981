#pragma once

#include <random>

#include "motion/kinematics/chain.h"
#include "motion/kinematics/chain_kinematics.h"
#include "tests/collision/meshes.h"
#include "tests/collision/segments.h"

namespace gsim::cell {

/// Six joints, some of which carry the work.
inline kinematics::ChainKinematics random_chain(std::mt19937& random, int tool_joints) {
    kinematics::Branch tool_side{random_pose(random, 100), {}, random_pose(random, 100)};
    kinematics::Branch work_side{random_pose(random, 100), {}, random_pose(random, 100)};
    for (int joint = 0; joint < 6; ++joint) {
        kinematics::Branch& branch = joint < tool_joints ? tool_side : work_side;
        const auto kind = random() % 2 == 0 ? rrs::JointKind::prismatic : rrs::JointKind::revolute;
        branch.links.push_back({joint, kind, random_pose(random, 100), random_pose(random, 100)});
    }
    return kinematics::ChainKinematics(kinematics::Chain(tool_side, work_side));
}

inline rrs::JointPos random_joints(std::mt19937& random, const rrs::JointPos& about, double max) {
    rrs::JointPos values = about;
    for (double& value : values) value += between(random, -max, max);
    return values;
}

inline rrs::JointPos random_start(std::mt19937& random) {
    return random_joints(random, rrs::JointPos::Zero(6), 2);
}

/// Returns a line of six joints, some of which follow laws of their own.
inline motion::Segment random_segment(std::mt19937& random, const rrs::JointPos& start, double max = 1) {
    motion::Segment segment =
        line(0, start, random_joints(random, start, max), {1, between(random, 0.5, 20)});
    for (int joint = 0; joint < 6; ++joint) {
        if (random() % 4 != 0) continue;
        const double distance = std::abs(segment.end[joint] - segment.start[joint]);
        segment.add_follower(joint, segment.end[joint] < segment.start[joint] ? -1 : 1,
                             motion::TimeLaw::with_duration(distance, segment.duration_s, 100 * distance));
    }
    return segment;
}

}  // namespace gsim::cell
