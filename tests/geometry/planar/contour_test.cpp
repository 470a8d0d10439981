#include "geometry/planar/contour.h"

#include <gtest/gtest.h>

#include "tests/geometry/planar/shapes.h"

namespace gsim::geometry::contour_test {

namespace {

constexpr double kPi = std::numbers::pi;

TEST(Contour, AreaAndLengthOfCircleAreExact) {
    const Contour round = circle({1000, -2000}, 7);
    EXPECT_NEAR(area_mm2(round), kPi * 49, 1e-9);
    EXPECT_NEAR(length_mm(round), kPi * 14, 1e-9);
}

TEST(Contour, AreaAndBoxOfRoundedSlotAreExact) {
    Contour slot;
    slot.closed = true;
    slot.vertices = {{{0, -2}, 0, 0}, {{10, -2}, 1, 0}, {{10, 2}, 0, 0}, {{0, 2}, 1, 0}};
    EXPECT_NEAR(area_mm2(slot), 40 + kPi * 4, 1e-9);
    EXPECT_NEAR(bounding_box(slot).high.x, 12, 1e-9);
    EXPECT_NEAR(bounding_box(slot).low.x, -2, 1e-9);
}

TEST(Contour, ReversalNegatesArea) {
    std::mt19937 random(3);
    Contour contour = star(random, 12, 5, 20, 0.5);
    const double area = area_mm2(contour);
    const double length = length_mm(contour);
    const Point first = contour.vertices.front().position;
    reverse(contour);
    EXPECT_NEAR(area_mm2(contour), -area, 1e-9);
    EXPECT_NEAR(length_mm(contour), length, 1e-9);
    EXPECT_EQ(contour.vertices.front().position, first);
}

TEST(Contour, SplitsArcLongerThanHalfTurn) {
    Contour contour;
    // Three quarters of a circle of radius 1 about the origin, from (1, 0) to (0, -1).
    append_edge(contour, {{1, 0}, {0, -1}, std::tan(3 * kPi / 8)}, 0);
    ASSERT_EQ(contour.edges(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(length(center(contour.edge(i))), 0, 1e-12);
        EXPECT_NEAR(radius_mm(contour.edge(i)), 1, 1e-12);
    }
}

TEST(Edge, SharesAndSubEdgesOfArcsAreConsistent) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-1, 1);
    for (int i = 0; i < 200; ++i) {
        const Edge edge{{value(random), value(random)}, {2 + value(random), value(random)}, value(random)};
        const double share = (value(random) + 1) / 2;
        const Point point = point_at(edge, share);
        EXPECT_NEAR(share_at(edge, point), share, 1e-9);
        EXPECT_NEAR(distance_mm(edge, point), 0, 1e-9);
        const Edge first = sub_edge(edge, 0, share);
        const Edge second = sub_edge(edge, share, 1);
        EXPECT_NEAR(length_mm(first) + length_mm(second), length_mm(edge), 1e-9);
        EXPECT_NEAR(distance(start_tangent(second), end_tangent(first)), 0, 1e-6);
    }
}

}  // namespace

}  // namespace gsim::geometry::contour_test
