#pragma once

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/planner/planner_setup.h"
#include "motion/segment/segment.h"

namespace gsim::motion {

inline constexpr double kRelative = 1e-9;
inline constexpr double kPath_mm = 1e-6;

/// Returns the min time between standstills, from first principles.
inline double trapezoid_s(double length, double speed, double acceleration) {
    if (length == 0) return 0;
    const bool reached = speed * speed / acceleration <= length;
    return reached ? length / speed + speed / acceleration : 2 * std::sqrt(length / acceleration);
}

inline bool is_on_arc(const Segment& segment, int joint) {
    const auto& carriers = segment.position_joints;
    return segment.kind == SegmentKind::circular &&
           std::find(carriers.begin(), carriers.end(), joint) != carriers.end();
}

/// Expects that speeds and accelerations of all joints keep their limits. On an arc the planner limits only
/// the part of the acceleration along the path.
inline void expect_joint_limits(const Segment& segment, const PlannerSetup& setup, int samples = 60) {
    for (int i = 0; i <= samples; ++i) {
        const JointState state = segment.at(segment.duration_s * i / samples);
        for (int joint = 0; joint < setup.joint_count(); ++joint) {
            const JointSetup& limits = setup.joints[static_cast<std::size_t>(joint)];
            ASSERT_LE(std::abs(state.velocity[joint]), limits.max_speed * (1 + kRelative))
                << "joint " << joint;
            if (is_on_arc(segment, joint)) continue;
            ASSERT_LE(std::abs(state.acceleration[joint]), limits.max_acceleration * (1 + kRelative))
                << "joint " << joint;
        }
    }
}

/// The lead law keeps a speed and an acceleration along the path.
inline void expect_path_limits(const Segment& segment, double speed, double acceleration) {
    for (int i = 0; i <= 60; ++i) {
        const LawState state = segment.master.at(segment.duration_s * i / 60);
        ASSERT_LE(state.v, speed * (1 + kRelative));
        ASSERT_LE(std::abs(state.a), acceleration * (1 + kRelative));
    }
}

/// Expects an exact start and end at standstill, and that positions, velocities and accelerations are
/// derivatives of each other. Over a small step a velocity that changes by less than a dt moves a joint by
/// its mean within a dt^2.
inline void expect_smooth(const Segment& segment) {
    const double dt = segment.duration_s / 400;
    ASSERT_EQ(segment.position_at(0), segment.start);
    ASSERT_EQ(segment.position_at(segment.duration_s), segment.end);
    ASSERT_EQ(segment.at(segment.duration_s).position, segment.end);
    const auto joints = segment.start.size();
    ASSERT_LE(segment.at(0).velocity.cwiseAbs().maxCoeff(), 1e-9);
    ASSERT_LE(segment.at(segment.duration_s).velocity.cwiseAbs().maxCoeff(), 1e-6);
    double steepest = 0;
    for (int i = 0; i <= 400; ++i)
        steepest = std::max(steepest, segment.at(i * dt).acceleration.cwiseAbs().maxCoeff());
    for (int i = 0; i < 400; ++i) {
        const JointState a = segment.at(i * dt);
        const JointState b = segment.at((i + 1) * dt);
        ASSERT_LT((a.position - segment.position_at(i * dt)).cwiseAbs().maxCoeff(), 1e-9);
        for (Eigen::Index joint = 0; joint < joints; ++joint) {
            const double mean = (a.velocity[joint] + b.velocity[joint]) / 2;
            const double moved = b.position[joint] - a.position[joint];
            ASSERT_NEAR(moved, mean * dt, 1.1 * steepest * dt * dt + 1e-9)
                << "joint " << joint << " step " << i;
            ASSERT_LE(std::abs(b.velocity[joint] - a.velocity[joint]), 1.1 * steepest * dt + 1e-9)
                << "joint " << joint << " step " << i;
        }
    }
}

}  // namespace gsim::motion
