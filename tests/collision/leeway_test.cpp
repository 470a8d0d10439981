#include "collision/pairs/leeway.h"

#include <gtest/gtest.h>

#include "collision/pairs/segment_motion.h"
#include "tests/collision/random_motion.h"

namespace gsim::cell::leeway_test {
namespace {

using Eigen::Vector3d;

constexpr int kSteps = 50;

/// Adds the distances of a link's points in a motion, seen from another link, by samples.
void add_ways(const SegmentMotion& motion, int link, int from, const std::vector<Vector3d>& points,
              std::vector<double>& ways_mm) {
    const auto place = [&](int step, const Vector3d& point) -> Vector3d {
        const LinkFrames links = motion.links_at(motion.segment().duration_s * step / kSteps);
        return links[static_cast<std::size_t>(from)].inverse() *
               (links[static_cast<std::size_t>(link)] * point);
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (int step = 0; step < kSteps; ++step)
            ways_mm[i] += (place(step + 1, points[i]) - place(step, points[i])).norm();
    }
}

TEST(Leeway, NoPointGoesFartherThanIsTaken) {
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
        const MotionPart whole = first.whole();
        const std::vector<int> between = joints_between(chain, link, from);
        const Ball ball{whole.from[static_cast<std::size_t>(link)] * middle, 20};
        JointReach reach_mm{};
        whole.chain.widen(reach_mm, ball, between);
        Leeway leeway;
        leeway.set(1e9, reach_mm, whole.chain.bound(ball, between).way_mm);
        std::vector<double> ways_mm(points.size());
        for (int more = 0; more < 10; ++more) {
            segment = random_segment(random, segment.end, 0.1);
            if (!leeway.take(travel_of(segment, 0, segment.duration_s))) break;
            ++taken;
            add_ways(SegmentMotion(chain, segment), link, from, points, ways_mm);
        }
        const double gone_mm = leeway.release_gone_mm();
        for (const double way_mm : ways_mm) EXPECT_LE(way_mm, gone_mm + 1e-9);
        EXPECT_EQ(leeway.release_gone_mm(), 0);
    }
    EXPECT_GT(taken, 200);
}

TEST(Leeway, EndsWithTheSlack) {
    const auto step = travel_of(line(0, joints(0, 0, 0), joints(3, 4, 0), {50}), 0, 0.1);
    Leeway leeway;
    EXPECT_FALSE(leeway.take(step));
    leeway.set(20, {}, 0);
    EXPECT_TRUE(leeway.take(step));  // 3 and 4, one after the other
    EXPECT_TRUE(leeway.take(step));
    EXPECT_FALSE(leeway.take(step));
    EXPECT_NEAR(leeway.release_gone_mm(), 14, 1e-9);
    leeway.clear();
    EXPECT_FALSE(leeway.take(step));
}

}  // namespace
}  // namespace gsim::cell::leeway_test
