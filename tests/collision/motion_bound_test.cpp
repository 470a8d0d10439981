#include "collision/pairs/motion_bound.h"

#include <gtest/gtest.h>

#include "collision/pairs/segment_motion.h"
#include "tests/collision/random_motion.h"

namespace gsim::cell::motion_bound_test {
namespace {

using Eigen::Vector3d;
using motion::Segment;

constexpr int kSteps = 200;

double distance_to_chord(const Vector3d& point, const Vector3d& from, const Vector3d& to) {
    const Vector3d displacement = to - from;
    const double share =
        displacement.squaredNorm() > 0 ? (point - from).dot(displacement) / displacement.squaredNorm() : 0;
    return (point - from - std::clamp(share, 0.0, 1.0) * displacement).norm();
}

/// Returns the true motion of points of a body in a part of a motion, by samples.
MotionBound measured(const SegmentMotion& motion, const MotionPart& part, const std::vector<Vector3d>& points,
                     int link, int from) {
    const auto place = [&](double t_s, const Vector3d& point) -> Vector3d {
        const LinkFrames links = motion.links_at(t_s);
        return links[static_cast<std::size_t>(from)].inverse() *
               (links[static_cast<std::size_t>(link)] * point);
    };
    MotionBound max;
    for (const Vector3d& point : points) {
        double displacement = 0;
        Vector3d last = place(part.from_s, point);
        const Vector3d start = last;
        const Vector3d end = place(part.to_s, point);
        for (int step = 1; step <= kSteps; ++step) {
            const Vector3d at = place(part.from_s + (part.to_s - part.from_s) * step / kSteps, point);
            displacement += (at - last).norm();
            max.deviation_mm = std::max(max.deviation_mm, distance_to_chord(at, start, end));
            last = at;
        }
        max.travel_mm = std::max(max.travel_mm, displacement);
    }
    return max;
}

TEST(MotionBound, HoldsForRandomChainsAndMotions) {
    std::mt19937 random(11);
    for (int i = 0; i < 60; ++i) {
        const int tool_joints = 3 + i % 4;
        const auto chain = random_chain(random, tool_joints);
        Segment segment = random_segment(random, random_start(random));
        if (i % 4 == 3) segment.superimposed = std::make_shared<const Segment>(segment);
        const SegmentMotion motion(chain, segment);
        const int link = 1 + static_cast<int>(random() % 6);
        const int from = static_cast<int>(random() % 7);
        const Vector3d middle = random_vector(random, 50);
        std::vector<Vector3d> points;
        for (int p = 0; p < 4; ++p) points.emplace_back(middle + 20 * random_vector(random, 1).normalized());
        MotionPart part = motion.full_motion();
        for (int halving = 0; halving < 3; ++halving) {
            const BoundingSphere ball{part.from[static_cast<std::size_t>(link)] * middle, 20};
            const MotionBound bound = part.chain.bound(ball, joints_between(chain, link, from));
            const MotionBound found = measured(motion, part, points, link, from);
            EXPECT_LE(found.travel_mm, bound.travel_mm + 1e-9);
            EXPECT_LE(found.deviation_mm, bound.deviation_mm + 1e-9);
            const LinkFrames half = motion.links_at(part.middle_s());
            part = random() % 2 == 0 ? motion.first_half(part, half) : motion.second_half(part, half);
        }
    }
}

// Links that drift in the world, on a link of the machine and on each other.
TEST(MotionBound, HoldsForIndependentLinks) {
    std::mt19937 random(17);
    for (int i = 0; i < 60; ++i) {
        const auto chain = random_chain(random, 3 + i % 4);
        const Segment segment = random_segment(random, random_start(random));
        const std::array<int, 3> parents{0, 1 + i % 6, 7};
        std::vector<MovingLink> drifting;
        for (const int parent : parents) {
            drifting.push_back({parent, random_pose(random, 100),
                                uniform_motion_between(random_pose(random, 100), random_pose(random, 100), 0,
                                                       segment.duration_s * between(random, 1, 5))});
        }
        const SegmentMotion motion(chain, segment, drifting);
        const int link = static_cast<int>(random() % 10);
        const int from = static_cast<int>(random() % 10);
        const Vector3d middle = random_vector(random, 50);
        const std::vector<Vector3d> points{middle, middle + 20 * random_vector(random, 1).normalized()};
        MotionPart part = motion.full_motion();
        for (int halving = 0; halving < 3; ++halving) {
            const BoundingSphere ball{part.from[static_cast<std::size_t>(link)] * middle, 20};
            const MotionBound bound = part.chain.bound(ball, joints_between(chain, link, from, parents));
            const MotionBound found = measured(motion, part, points, link, from);
            EXPECT_LE(found.travel_mm, bound.travel_mm + 1e-9);
            EXPECT_LE(found.deviation_mm, bound.deviation_mm + 1e-9);
            const LinkFrames half = motion.links_at(part.middle_s());
            part = random() % 2 == 0 ? motion.first_half(part, half) : motion.second_half(part, half);
        }
    }
}

// The tool moves on a great circle while its TCP continues, in proportion to the path or to the time.
TEST(MotionBound, HoldsOnGreatCirclesOfTool) {
    std::mt19937 random(13);
    const machine::Machine machine = af5();
    const auto kinematics = machine::make_kinematics(machine);
    ASSERT_TRUE(kinematics->tilting_head());
    int found = 0;
    for (int i = 0; i < 60; ++i) {
        const rrs::JointPos start = joints(0, 0, 0, between(random, -1, 1), between(random, 0.05, 1.4));
        const rrs::JointPos end = joints(30, 40, 0, between(random, -1, 1), between(random, 0.05, 1.4));
        const auto circle = motion::OrientationArc::between(*kinematics->tilting_head(), start, end);
        if (!circle) continue;
        ++found;
        Segment segment = line(0, start, end, {50, 490});
        segment.orientation = std::make_shared<const motion::OrientationArc>(*circle);
        if (i % 2 == 0)
            segment.superimposed = std::make_shared<const Segment>(line(0, start, start, {50, 490}));
        const SegmentMotion motion(*kinematics, segment);
        MotionPart part = motion.full_motion();
        for (int halving = 0; halving < 4; ++halving) {
            const Vector3d middle = random_vector(random, 100);
            const BoundingSphere ball{part.from[5] * middle, 0};
            const MotionBound bound = part.chain.bound(ball, joints_between(*kinematics, 5, 0));
            const MotionBound measured_bound = measured(motion, part, {middle}, 5, 0);
            EXPECT_LE(measured_bound.travel_mm, bound.travel_mm + 1e-9);
            EXPECT_LE(measured_bound.deviation_mm, bound.deviation_mm + 1e-9);
            const LinkFrames half = motion.links_at(part.middle_s());
            part = random() % 2 == 0 ? motion.first_half(part, half) : motion.second_half(part, half);
        }
    }
    EXPECT_GT(found, 20);
}

TEST(MotionBound, LinesHaveNoDeviation) {
    const machine::Machine machine = af5();
    const auto kinematics = machine::make_kinematics(machine);
    const Segment segment = line(0, joints(0, 0, 0), joints(30, 40, 0), {50, 490});
    const SegmentMotion motion(*kinematics, segment);
    const MotionBound bound =
        motion.full_motion().chain.bound({Vector3d::Zero(), 100}, joints_between(*kinematics, 5, 0));
    EXPECT_NEAR(bound.travel_mm, 50, 1e-9);
    EXPECT_EQ(bound.deviation_mm, 0);
    EXPECT_NEAR(motion.full_motion()
                    .chain.bound({Vector3d::Zero(), 100}, joints_between(*kinematics, 1, 0))
                    .travel_mm,
                30, 1e-9);
    EXPECT_NEAR(motion.full_motion()
                    .chain.bound({Vector3d::Zero(), 100}, joints_between(*kinematics, 5, 1))
                    .travel_mm,
                40, 1e-9);
}

TEST(MotionBound, ArcsDeviateByTheirSagitta) {
    const machine::Machine machine = af5();
    const auto kinematics = machine::make_kinematics(machine);
    const Segment segment = turn(0, joints(500, 500, 0), 100, {50});
    const SegmentMotion motion(*kinematics, segment);
    MotionPart part = motion.full_motion();
    for (int halving = 0; halving < 6; ++halving)
        part = motion.first_half(part, motion.links_at(part.middle_s()));
    const double angle = 2 * M_PI / 64;
    const MotionBound bound = part.chain.bound({Vector3d::Zero(), 100}, joints_between(*kinematics, 5, 0));
    EXPECT_NEAR(bound.travel_mm, 100 * angle, 1e-9);
    EXPECT_NEAR(bound.deviation_mm, 100 * (1 - std::cos(angle / 2)), 1e-4);
}

TEST(MotionBound, TravelOfTurnIsAngleTimesBodyReach) {
    const machine::Machine machine = af5();
    const auto kinematics = machine::make_kinematics(machine);
    const Segment segment = line(0, joints(0, 0, 0), joints(0, 0, 0, 0.1, 0), {1});
    const SegmentMotion motion(*kinematics, segment);
    const MotionBound bound =
        motion.full_motion().chain.bound({Vector3d(30, 40, 7), 10}, joints_between(*kinematics, 5, 0));
    EXPECT_NEAR(bound.travel_mm, 0.1 * 60, 1e-9);
    EXPECT_NEAR(bound.deviation_mm, 0.1 * 0.1 * 60 / 8, 1e-9);
}

}  // namespace
}  // namespace gsim::cell::motion_bound_test
