#pragma once

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "motion/kinematics/chain.h"
#include "motion/kinematics/pose.h"

namespace gsim::kinematics {

/// Random machines and poses from a fixed seed.
class RandomPoses {
  public:
    explicit RandomPoses(unsigned seed) : random_(seed) {}

    double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }

    /// Returns any position within `mm` of the origin, and any orientation.
    rrs::CartPos pose(double mm) {
        return pose_from_rpy({.x_mm = number(-mm, mm),
                              .y_mm = number(-mm, mm),
                              .z_mm = number(-mm, mm),
                              .roll_rad = number(-3, 3),
                              .pitch_rad = number(-1.5, 1.5),
                              .yaw_rad = number(-3, 3)});
    }

    Link link(int joint, rrs::JointKind kind) {
        return {.joint = joint, .kind = kind, .before = pose(100), .after = pose(100)};
    }

    /// Slides within a metre, turns within half a turn and a bit.
    rrs::JointPos joints(const Chain& chain) {
        rrs::JointPos values(chain.joint_count());
        for (int i = 0; i < chain.joint_count(); ++i)
            values[i] = chain.kind(i) == rrs::JointKind::prismatic ? number(-1000, 1000) : number(-3.5, 3.5);
        return values;
    }

  private:
    std::mt19937 random_;
};

/// Returns the distance of two poses, the larger of mm and rad.
inline double pose_distance(const rrs::CartPos& a, const rrs::CartPos& b) {
    const Eigen::Quaterniond turn(a.linear().transpose() * b.linear());
    return std::max((a.translation() - b.translation()).norm(),
                    2 * std::atan2(turn.vec().norm(), std::abs(turn.w())));
}

}  // namespace gsim::kinematics
