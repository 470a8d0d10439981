#pragma once

#include <gtest/gtest.h>

#include "tests/motion/machines.h"
#include "tests/motion/segment_checks.h"

namespace gsim::motion {

/// Sets a deceleration other than the acceleration, and finite jerks, for each joint.
inline void set_ramps(PlannerSetup& setup, std::mt19937& random, bool jerk) {
    std::uniform_real_distribution<double> log_scale(-1, 1);
    for (JointSetup& joint : setup.joints) {
        joint.max_deceleration = joint.max_acceleration * std::exp(log_scale(random));
        joint.max_jerk = joint.max_acceleration * 10 * std::exp(log_scale(random));
    }
    setup.controller.ramps.limit_jerk = jerk;
}

/// Expects that a law keeps speed, acceleration, deceleration and jerk. Within the law its speed does not
/// jump, nor, with a finite jerk, its acceleration.
inline void expect_law_limits(const TimeLaw& law, const LawLimits& limits) {
    const double peak = law.peak_speed();
    ASSERT_LE(peak, limits.max_speed * (1 + kRelative));
    double v = law.sections().empty() ? 0 : law.sections().front().v0;
    double a = 0;
    for (const LawSection& section : law.sections()) {
        const double t = section.duration_s;
        ASSERT_LE(std::abs(section.jerk), limits.jerk * (1 + kRelative));
        ASSERT_NEAR(section.v0, v, kRelative * (peak + 1));
        for (const double at : {section.a0, section.a0 + section.jerk * t}) {
            ASSERT_LE(at, limits.acceleration * (1 + kRelative));
            ASSERT_GE(at, -limits.deceleration * (1 + kRelative));
        }
        if (std::isfinite(limits.jerk) && &section != law.sections().data()) {
            ASSERT_NEAR(section.a0, a, 1e-6 * (1 + std::abs(a)));
        }
        v = section.v0 + t * (section.a0 + t * section.jerk / 2);
        a = section.a0 + t * section.jerk;
        ASSERT_GE(v, -kRelative * (peak + 1));
    }
}

/// Returns the machine's limits along a segment's path, from its joints; not for arcs.
inline LawLimits machine_limits(const Segment& segment, const PlannerSetup& setup) {
    LawLimits limits;
    for (int joint = 0; joint < setup.joint_count(); ++joint) {
        bool follows = false;
        for (const Follower& follower : segment.followers()) follows = follows || follower.joint == joint;
        const double change = std::abs(segment.end[joint] - segment.start[joint]);
        if (follows || change <= 1e-9) continue;
        const double share = change / segment.master.length();
        const JointSetup& joint_setup = setup.joints[static_cast<std::size_t>(joint)];
        limits.max_speed = std::min(limits.max_speed, joint_setup.max_speed / share);
        limits.acceleration = std::min(limits.acceleration, joint_setup.max_acceleration / share);
        limits.deceleration = std::min(limits.deceleration, joint_setup.deceleration() / share);
        if (setup.controller.ramps.limit_jerk)
            limits.jerk = std::min(limits.jerk, joint_setup.max_jerk / share);
    }
    return limits;
}

/// All laws of a segment keep the limits of the joints; ends within rounding of a cut are not looked at.
inline void expect_segment_limits(const Segment& segment, const PlannerSetup& setup) {
    if (segment.kind == SegmentKind::rest || !(segment.master.length() > 1e-6)) return;
    LawLimits limits = machine_limits(segment, setup);
    for (double* limit : {&limits.max_speed, &limits.acceleration, &limits.deceleration, &limits.jerk})
        *limit *= 1 + 1e-7 / segment.master.length();  // rounding of the ends that give the shares
    if (segment.kind != SegmentKind::circular) expect_law_limits(segment.master, limits);
    for (const Follower& follower : segment.followers()) {
        const JointSetup& joint_setup = setup.joints[static_cast<std::size_t>(follower.joint)];
        expect_law_limits(follower.law,
                          {joint_setup.max_speed, joint_setup.max_acceleration, joint_setup.deceleration(),
                           setup.controller.ramps.limit_jerk ? joint_setup.max_jerk : kUnlimited});
    }
}

/// Expects that consecutive segments join in time, position and speed along the path.
inline void expect_joined(const std::vector<Segment>& segments) {
    for (std::size_t i = 1; i < segments.size(); ++i) {
        const Segment& before = segments[i - 1];
        const Segment& segment = segments[i];
        ASSERT_NEAR(segment.start_s, before.end_s(), 1e-9);
        ASSERT_LT((segment.start - before.end).norm(), 1e-7);
        ASSERT_LT((segment.position_at(1e-12) - segment.start).norm(), 1e-6);
        const double speed = before.master.end_speed();
        ASSERT_NEAR(segment.master.start_speed(), speed, 1e-6 * (1 + speed)) << i;
    }
}

}  // namespace gsim::motion
