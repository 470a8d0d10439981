#include "cam/cutting/feeds.h"

#include <gtest/gtest.h>

#include "tests/geometry/planar/shapes.h"

namespace gsim::cutting::feeds_test {

namespace {

CutRules rules() {
    CutRules rules;
    rules.kerf_mm = 1;
    rules.speed_mm_min = 600;
    rules.feed_on_arc_mm_min = [](double radius_mm) { return 100 * radius_mm; };
    rules.feed_in_corner_mm_min = [](double turn_rad) { return std::abs(turn_rad) > 0.1 ? 200.0 : 600.0; };
    rules.corner_zone_mm = 2;
    return rules;
}

TEST(Feeds, ReducesFeedInCornerZones) {
    double slow_mm = 0;
    double sum_mm = 0;
    const std::vector<FeedSegment> edges = assign_feeds(geometry::rectangle({0, 0}, {30, 20}), rules());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        sum_mm += length_mm(edges[i].edge);
        if (edges[i].feed_mm_min == 200) slow_mm += length_mm(edges[i].edge);
        EXPECT_NEAR(distance(edges[i].edge.end, edges[(i + 1) % edges.size()].edge.start), 0, 1e-12);
    }
    EXPECT_NEAR(sum_mm, 100, 1e-9);
    EXPECT_NEAR(slow_mm, 4 * 2 * 2, 1e-9);
}

TEST(Feeds, EdgesShorterThanZonesHaveCornerFeed) {
    for (const FeedSegment& edge : assign_feeds(geometry::rectangle({0, 0}, {3, 1}), rules()))
        EXPECT_EQ(edge.feed_mm_min, 200);
}

TEST(Feeds, ReducesFeedOnSmallArcsWithoutCornerZones) {
    const auto small = assign_feeds(geometry::circle({}, 3), rules());
    ASSERT_EQ(small.size(), 2U);
    EXPECT_NEAR(small[0].feed_mm_min, 300, 1e-9);
    EXPECT_NEAR(assign_feeds(geometry::circle({}, 30), rules())[0].feed_mm_min, 600, 1e-9);
}

TEST(Feeds, SegmentsKeepLengthAndAreaOfRandomShapes) {
    std::mt19937 random(5);
    for (int i = 0; i < 50; ++i) {
        const geometry::Contour contour = geometry::star(random, 20, 3, 20, 0.5);
        geometry::Contour repeated;
        for (const FeedSegment& edge : assign_feeds(contour, rules())) append_edge(repeated, edge.edge, 0);
        EXPECT_NEAR(length_mm(repeated), length_mm(contour), 1e-6);
        repeated.vertices.pop_back();
        repeated.closed = true;
        EXPECT_NEAR(area_mm2(repeated), area_mm2(contour), 1e-6);
    }
}

}  // namespace

}  // namespace gsim::cutting::feeds_test
