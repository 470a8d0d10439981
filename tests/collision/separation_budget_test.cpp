#include "collision/pairs/separation_budget.h"

#include <gtest/gtest.h>

#include "collision/pairs/segment_motion.h"
#include "tests/collision/random_motion.h"

namespace gsim::cell::leeway_test {
namespace {

using Eigen::Vector3d;

constexpr int kSteps = 50;

/// Adds the distances of a link's points in a motion, seen from another link, by samples.
void add_ways(const SegmentMotion& motion, int link, int from, const std::vector<Vector3d>& points,
              std::vector<double>& travels_mm) {
    const auto place = [&](int step, const Vector3d& point) -> Vector3d {
        const LinkFrames links = motion.links_at(motion.segment().duration_s * step / kSteps);
        return links[static_cast<std::size_t>(from)].inverse() *
               (links[static_cast<std::size_t>(link)] * point);
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (int step = 0; step < kSteps; ++step)
            travels_mm[i] += (place(step + 1, points[i]) - place(step, points[i])).norm();
    }
}

TEST(SeparationBudget, NoPointTravelsFartherThanSpent) {
    std::mt19937 random(23);
    int taken = 0;
    for (int i = 0; i < 40; ++i) {
        const auto chain = random_chain(random, 3 + i % 4);
        const int link = 1 + static_cast<int>(random() % 6);
        const int from = static_cast<int>(random() % 7);
        const Vector3d middle = random_vector(random, 50);
        const std::vector<Vector3d> points{middle, middle + 20 * random_vector(random, 1).normalized()};
        motion::Segment segment = random_segment(random, random_start(random), 0.2);
        const SegmentMotion first(chain, segment);
        const MotionPart full_motion = first.full_motion();
        const std::vector<int> between = joints_between(chain, link, from);
        const BoundingSphere ball{full_motion.from[static_cast<std::size_t>(link)] * middle, 20};
        JointReach reach_mm{};
        full_motion.chain.expand(reach_mm, ball, between);
        SeparationBudget leeway;
        leeway.set(1e9, reach_mm, full_motion.chain.bound(ball, between).travel_mm);
        std::vector<double> travels_mm(points.size());
        for (int more = 0; more < 10; ++more) {
            segment = random_segment(random, segment.end, 0.1);
            if (!leeway.spend(joint_travel(segment, 0, segment.duration_s))) break;
            ++taken;
            add_ways(SegmentMotion(chain, segment), link, from, points, travels_mm);
        }
        const double travelled_mm = leeway.release_travelled_mm();
        for (const double travel_mm : travels_mm) EXPECT_LE(travel_mm, travelled_mm + 1e-9);
        EXPECT_EQ(leeway.release_travelled_mm(), 0);
    }
    EXPECT_GT(taken, 200);
}

TEST(SeparationBudget, RejectsTravelBeyondSlack) {
    const auto step = joint_travel(line(0, joints(0, 0, 0), joints(3, 4, 0), {50}), 0, 0.1);
    SeparationBudget leeway;
    EXPECT_FALSE(leeway.spend(step));
    leeway.set(20, {}, 0);
    EXPECT_TRUE(leeway.spend(step));  // 3 and 4, one after the other
    EXPECT_TRUE(leeway.spend(step));
    EXPECT_FALSE(leeway.spend(step));
    EXPECT_NEAR(leeway.release_travelled_mm(), 14, 1e-9);
    leeway.clear();
    EXPECT_FALSE(leeway.spend(step));
}

}  // namespace
}  // namespace gsim::cell::leeway_test
